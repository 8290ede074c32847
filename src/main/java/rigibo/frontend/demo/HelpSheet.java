package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.util.ArrayList;
import java.util.List;

/** The keys of a demo, and the stages into which its step was compiled. */
final class HelpSheet {

    /** Number of lines with keys. */
    private static final int KEYS = 7;

    private static final double TOP = 36;
    private static final double KEY_SIZE = 18;
    private static final double KEY_HEIGHT = 28;
    private static final double HEADING = 240;
    private static final double PLAN_SIZE = 16;
    private static final double PLAN_HEIGHT = 23;
    private static final double LEFT = 40;

    /** The column in which the words begin, after the stage they belong to. */
    private static final String INDENT = " ".repeat(11);

    private HelpSheet() {}

    /** Draws the keys and the lines of a plan. */
    static void draw(Words words, String plan, Canvas canvas) {
        // Covers everything with a veil, since words would shine through a panel.
        canvas.cover(Color.DUSK_TOP.alpha(0.96));
        for (int i = 0; i < KEYS; i++) {
            centred(words.of("help.keys." + i), TOP + KEY_HEIGHT * i, Color.TEXT, canvas);
        }
        centred(words.of("help.plan"), HEADING, Color.BRASS, canvas);
        double y = HEADING + 2 * PLAN_HEIGHT;
        for (String line : wrapped(plan, canvas)) {
            canvas.text(
                    line, LEFT, y, PLAN_SIZE, Canvas.Font.NUMBERS, Canvas.Align.LEFT, Color.TEXT);
            y += PLAN_HEIGHT;
        }
    }

    private static void centred(String words, double y, Color color, Canvas canvas) {
        canvas.text(
                words,
                Scene.WIDTH / 2.0,
                y,
                KEY_SIZE,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                color);
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
        double width = canvas.textWidth(line, PLAN_SIZE, Canvas.Font.NUMBERS);
        return width <= Scene.WIDTH - 2 * LEFT;
    }
}
