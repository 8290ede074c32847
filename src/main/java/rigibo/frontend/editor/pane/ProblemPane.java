package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Finding;
import rigibo.frontend.puzzle.ProblemWords;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Sign;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/** The problems, one line each; a press selects the item at fault. */
public final class ProblemPane {

    private static final double USUAL_ROW = 24;
    private static final double ICON = 22;

    private ProblemPane() {}

    /**
     * Draws as many as there is room for, and how many more there are; returns the one under the
     * pointer.
     */
    public static Optional<Finding> draw(
            Pane pane, Area area, List<Finding> findings, Consumer<String> choose) {
        pane.plate(area);
        Area inner = area.inset(8);
        int rows = (int) (inner.height() / height(pane)) - 1;
        boolean fits = findings.size() <= rows;
        int shown = fits ? findings.size() : rows - 1;
        if (findings.isEmpty()) {
            sound(pane, inner);
            return Optional.empty();
        }
        String heading = pane.words().of("editor.problems", findings.size());
        pane.text(row(pane, inner, 0), heading, Canvas.Align.LEFT, Color.BRASS);
        for (int i = 0; i < shown; i++) {
            row(pane, row(pane, inner, i + 1), findings.get(i), choose);
        }
        if (!fits) {
            String more = pane.words().of("editor.more", findings.size() - shown);
            pane.text(row(pane, inner, rows), more, Canvas.Align.LEFT, Color.TEXT_DIM);
        }
        return IntStream.range(0, shown)
                .filter(i -> pane.isHot(row(pane, inner, i + 1)))
                .mapToObj(findings::get)
                .findFirst();
    }

    private static void sound(Pane pane, Area inner) {
        List<String> lines =
                Lines.of(
                        pane.canvas(),
                        pane.words().of("editor.sound"),
                        Pane.TEXT,
                        Canvas.Font.WORDS,
                        inner.width() - USUAL_ROW / 2);
        for (int i = 0; i < lines.size(); i++) {
            Area line = new Area(inner.x(), inner.y() + i * USUAL_ROW, inner.width(), USUAL_ROW);
            pane.text(line, lines.get(i), Canvas.Align.LEFT, Color.GOOD);
        }
    }

    /** Height of a heading and a number of problems, px; at least two rows. */
    public static double height(Pane pane, int problems) {
        return Math.max(2, problems + 1) * height(pane);
    }

    private static double height(Pane pane) {
        return pane.pressable(USUAL_ROW);
    }

    private static Area row(Pane pane, Area inner, int i) {
        double height = height(pane);
        return new Area(inner.x(), inner.y() + i * height, inner.width(), height);
    }

    private static void row(Pane pane, Area row, Finding finding, Consumer<String> choose) {
        icon(pane.canvas(), row.x() + ICON / 2, row.middleY(), finding);
        Area words = new Area(row.x() + ICON, row.y(), row.width() - ICON, row.height());
        Color ink = pane.isHot(row) ? Color.TEXT : Color.TEXT_DIM;
        pane.text(words, name(pane, finding), Canvas.Align.LEFT, ink);
        pane.spots().add(row, name(pane, finding), "", () -> choose.accept(finding.item()));
    }

    private static String name(Pane pane, Finding finding) {
        return ProblemWords.title(pane.words(), finding.problem());
    }

    /** What is wrong and how to mend it, in a sentence of the player's language. */
    public static String told(Pane pane, Finding finding) {
        return ProblemWords.told(pane.words(), finding.problem());
    }

    /** A cross in a disc for an error, a bar in a ring for a warning: not by colour alone. */
    public static void icon(Canvas canvas, double x, double y, Finding finding) {
        if (finding.problem().isError()) {
            canvas.disc(x, y, 9, Color.BAD);
            Sign.cross(canvas, x, y, 4, 2.5, Color.DUSK_TOP);
        } else {
            canvas.disc(x, y, 9, Color.DUSK_TOP);
            canvas.ring(x, y, 8, 2, 1, Color.BRASS);
            canvas.line(x, y - 4, x, y + 4, 2.5, Color.BRASS);
        }
    }
}
