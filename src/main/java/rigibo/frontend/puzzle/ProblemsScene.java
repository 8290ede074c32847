package rigibo.frontend.puzzle;

import rigibo.frontend.document.Problem;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Lines;

import java.util.List;

/**
 * Shows the problems of a file that could not be opened, each with its place in the file for the
 * author.
 */
final class ProblemsScene implements Scene {

    private static final double EDGE = 24;
    private static final double PADDING = 20;
    private static final double LEFT = EDGE + PADDING;
    private static final double TEXT_WIDTH = WIDTH - 2 * LEFT;
    private static final double HEADLINE = EDGE + 40;
    private static final double FIRST_LINE = EDGE + 92;
    private static final double LAST_LINE = HEIGHT - EDGE - 76;
    private static final double SIZE = 16;
    private static final double LINE = 22;
    private static final double WHY = 18;

    /** Distance between two problems, px. */
    private static final double GAP = 8;

    private final Director director;
    private final List<Problem> problems;

    ProblemsScene(Director director, List<Problem> problems) {
        this.director = director;
        this.problems = List.copyOf(problems);
    }

    @Override
    public String title() {
        return "RigiBo";
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        canvas.panel(EDGE, EDGE, WIDTH - 2 * EDGE, HEIGHT - 2 * EDGE, 18, Color.PANEL);
        canvas.frame(EDGE, EDGE, WIDTH - 2 * EDGE, HEIGHT - 2 * EDGE, 18, Color.BAD);
        String headline = director.words().of("replay.cannot-be-opened");
        line(canvas, headline, HEADLINE, 26, Canvas.Font.WORDS, Color.BRASS);
        drawProblems(canvas);
        String leave = director.words().of("replay.leave-problems");
        line(canvas, leave, HEIGHT - EDGE - 30, SIZE, Canvas.Font.WORDS, Color.TEXT_DIM);
    }

    private void drawProblems(Canvas canvas) {
        double y = FIRST_LINE;
        for (int i = 0; i < problems.size(); i++) {
            List<String> why = why(canvas, problems.get(i));
            List<String> where = where(canvas, problems.get(i));
            if (y + (why.size() + where.size()) * LINE > LAST_LINE) {
                String more = director.words().of("replay.more-problems", problems.size() - i);
                line(canvas, more, y, SIZE, Canvas.Font.WORDS, Color.BRASS);
                break;
            }
            for (String words : why) {
                line(canvas, words, y, WHY, Canvas.Font.WORDS, Color.TEXT);
                y += LINE;
            }
            for (String words : where) {
                line(canvas, words, y, SIZE, Canvas.Font.NUMBERS, Color.TEXT_DIM);
                y += LINE;
            }
            y += GAP;
        }
    }

    private List<String> why(Canvas canvas, Problem problem) {
        String words = ProblemWords.told(director.words(), problem);
        return Lines.of(canvas, words, WHY, Canvas.Font.WORDS, TEXT_WIDTH);
    }

    private static List<String> where(Canvas canvas, Problem problem) {
        return Lines.of(canvas, problem.where(), SIZE, Canvas.Font.NUMBERS, TEXT_WIDTH);
    }

    private static void line(
            Canvas canvas, String words, double y, double size, Canvas.Font font, Color color) {
        canvas.text(words, LEFT, y, size, font, Canvas.Align.LEFT, color);
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        director.showMenu();
    }

    @Override
    public void keyPressed(Key key) {
        if (key == Key.ENTER || key == Key.SPACE) {
            director.showMenu();
        }
    }
}
