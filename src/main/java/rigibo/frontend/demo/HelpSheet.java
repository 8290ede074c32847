package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;

import java.util.ArrayList;
import java.util.List;

/**
 * What F1 shows over a demo: to the player what there is to see and which keys do what, and on a
 * page of its own the stages into which the engine compiled a step.
 */
enum HelpSheet {
    CLOSED,
    PLAYER,
    STAGES;

    /** Rows of keys and what they do. */
    private static final int ROWS = 16;

    private static final double TITLE = 56;
    private static final double TITLE_SIZE = 28;
    private static final double TEXT = 102;
    private static final double TEXT_SIZE = 18;
    private static final double LINE = 26;

    private static final double TABLE = 212;
    private static final double ROW = 32;

    /** Where keys end, and where what they do begins, px. */
    private static final double KEYS = 250;

    private static final double MEANINGS = 274;

    private static final double PLAN_SIZE = 16;
    private static final double PLAN = 112;
    private static final double LEFT = 40;
    private static final double WIDTH = Scene.WIDTH - 2 * LEFT;

    /** The column in which the words begin, after the stage they belong to. */
    private static final String INDENT = " ".repeat(11);

    /** What F1 leads to. */
    HelpSheet next() {
        return values()[(ordinal() + 1) % values().length];
    }

    /** Draws it over the demo of a name, whose step is compiled to the lines of a plan. */
    void draw(Words words, String name, String plan, Canvas canvas) {
        if (this == CLOSED) {
            return;
        }
        // Covers everything with a veil, since words would shine through a panel.
        canvas.cover(Color.DUSK_TOP.alpha(0.96));
        String title = words.of("scene." + name);
        if (this == PLAYER) {
            drawTitle(canvas, title);
            drawWhatThereIsToSee(canvas, words.of("help." + name));
            drawKeys(canvas, words);
        } else {
            drawTitle(canvas, words.of("help.plan", title));
            drawPlan(canvas, new PlanWords(words).of(plan));
        }
    }

    private static void drawTitle(Canvas canvas, String title) {
        Print.centred(canvas, title, Scene.WIDTH / 2.0, TITLE, TITLE_SIZE, Color.BRASS);
    }

    private static void drawWhatThereIsToSee(Canvas canvas, String text) {
        double y = TEXT;
        for (String line : Lines.of(canvas, text, TEXT_SIZE, Canvas.Font.WORDS, WIDTH)) {
            Print.centred(canvas, line, Scene.WIDTH / 2.0, y, TEXT_SIZE, Color.TEXT);
            y += LINE;
        }
    }

    private static void drawKeys(Canvas canvas, Words words) {
        for (int i = 0; i < ROWS; i++) {
            double y = TABLE + i * ROW;
            Print.right(canvas, words.of("help.key." + i), KEYS, y, TEXT_SIZE, Color.BRASS);
            Print.left(canvas, words.of("help.does." + i), MEANINGS, y, TEXT_SIZE, Color.TEXT);
        }
    }

    private static void drawPlan(Canvas canvas, String plan) {
        double y = PLAN;
        List<String> lines = wrapped(plan, canvas);
        // Large letters make more lines than stand there at their usual distance.
        double pitch = Math.min(LINE, (Scene.HEIGHT - LINE - PLAN) / lines.size());
        for (String line : lines) {
            canvas.text(
                    line, LEFT, y, PLAN_SIZE, Canvas.Font.NUMBERS, Canvas.Align.LEFT, Color.TEXT);
            y += pitch;
        }
    }

    /** Wraps the lines of a plan at the edge of the window, between words. */
    private static List<String> wrapped(String plan, Canvas canvas) {
        List<String> lines = new ArrayList<>();
        for (String line : plan.lines().toList()) {
            String rest = line;
            while (!fits(rest, canvas)) {
                int end = rest.lastIndexOf(' ');
                while (!fits(rest.substring(0, end), canvas)) {
                    end = rest.lastIndexOf(' ', end - 1);
                }
                lines.add(rest.substring(0, end));
                rest = INDENT + rest.substring(end + 1);
            }
            lines.add(rest);
        }
        return lines;
    }

    private static boolean fits(String line, Canvas canvas) {
        return canvas.textWidth(line, PLAN_SIZE, Canvas.Font.NUMBERS) <= WIDTH;
    }
}
