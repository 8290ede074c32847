package rigibo.frontend.editor.pane;

import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The tools by purpose, each with its key and icon. */
public enum Craft {
    SELECT(Key.V),
    BOX(Key.B),
    DISC(Key.C),
    CORNERS(Key.P),
    REGULAR(Key.N),
    BALL(Key.O),
    CAPSULE(Key.A),
    LANDSCAPE(Key.D),
    GLUE(Key.J),
    HINGE(Key.H),
    WELD(Key.X),
    WHEEL(Key.W),
    SLIDE(Key.L),
    ROD(Key.R),
    ROPE(Key.U),
    SPRING(Key.F);

    private static final double HALF = 11;
    private static final double STROKE = 2.5;

    private final Key shortcut;

    Craft(Key shortcut) {
        this.shortcut = shortcut;
    }

    /** The tool of a key. */
    public static Optional<Craft> of(Key key) {
        return Arrays.stream(values()).filter(craft -> craft.shortcut == key).findFirst();
    }

    /** The type of its joints, if it makes joints. */
    public Optional<LevelJoint.Type> joint() {
        return Arrays.stream(LevelJoint.Type.values())
                .filter(type -> type.name().equals(name()))
                .findFirst();
    }

    /** The last part of the key of its instructions in the bundles. */
    public String hint() {
        return switch (this) {
            case SELECT -> "select";
            case BOX, DISC, CAPSULE, BALL -> "draw";
            case LANDSCAPE -> "landscape";
            case GLUE -> "glue";
            case CORNERS -> "corners";
            case REGULAR -> "regular";
            case HINGE, WELD, WHEEL, SLIDE, ROD, ROPE, SPRING -> "joint";
        };
    }

    String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    void draw(Canvas canvas, double x, double y, Color ink) {
        switch (this) {
            case SELECT -> arrow(canvas, x, y, ink);
            case BOX -> canvas.frame(x - HALF, y - HALF + 2, 2 * HALF, 2 * HALF - 4, 2, ink);
            case DISC -> canvas.ring(x, y, HALF, STROKE, 1, ink);
            case CORNERS -> closed(canvas, ink, x - 11, y + 9, x + 11, y + 9, x + 5, y - 10);
            case REGULAR -> hexagon(canvas, x, y, ink);
            case BALL -> {
                canvas.disc(x, y, HALF, ink);
                canvas.ring(x, y, HALF - 4, 2, 1, Color.IRON);
            }
            case CAPSULE -> canvas.frame(x - HALF, y - 6, 2 * HALF, 12, 6, ink);
            case LANDSCAPE ->
                    open(canvas, ink, x - 12, y + 4, x - 5, y - 6, x + 2, y + 6, x + 12, y);
            case GLUE -> {
                canvas.frame(x - HALF, y - HALF, 14, 14, 2, ink);
                canvas.panel(x - 3, y - 3, 14, 14, 2, ink);
            }
            case HINGE, WELD, WHEEL, SLIDE, ROD, ROPE, SPRING ->
                    JointIcon.draw(canvas, joint().orElseThrow(), x, y, ink);
        }
    }

    private static void arrow(Canvas canvas, double x, double y, Color ink) {
        closed(canvas, ink, x - 6, y - 11, x + 8, y + 3, x - 6, y + 7);
        canvas.line(x, y + 4, x + 4, y + 12, STROKE, ink);
    }

    private static void hexagon(Canvas canvas, double x, double y, Color ink) {
        double tall = HALF;
        double half = HALF / 2;
        closed(
                canvas, ink, x - half, y - tall, x + half, y - tall, x + tall, y, x + half,
                y + tall, x - half, y + tall, x - tall, y);
    }

    private static void open(Canvas canvas, Color ink, double... xy) {
        for (int i = 0; i + 3 < xy.length; i += 2) {
            canvas.line(xy[i], xy[i + 1], xy[i + 2], xy[i + 3], STROKE, ink);
        }
    }

    private static void closed(Canvas canvas, Color ink, double... xy) {
        for (int i = 0; i < xy.length; i += 2) {
            int next = (i + 2) % xy.length;
            canvas.line(xy[i], xy[i + 1], xy[next], xy[next + 1], STROKE, ink);
        }
    }
}
