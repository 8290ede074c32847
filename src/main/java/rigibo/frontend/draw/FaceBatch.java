package rigibo.frontend.draw;

import rigibo.frontend.scene.Canvas.Mood;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

/**
 * Faces of RigiBos, drawn by one call from a sheet of expressions; pupils are drawn as separate
 * dots.
 */
final class FaceBatch {

    private static final int TEXELS = 128;

    /** Scale below which a face does not show, px per unit. */
    private static final double LEAST = 6.5;

    /**
     * Largest unit of a face, m; the unit is half a square body's side, and a little more for long
     * bodies.
     */
    private static final double MOST = 0.46;

    private static final double OF_WIDTH = 1.2;
    private static final double OF_HEIGHT = 1.9;

    /**
     * Half the width of the sheet about a face's middle; the shader that bakes it uses the same
     * number.
     */
    private static final double REACH = 0.7;

    /** Position of the eyes, and the distance by which pupils move. */
    private static final double EYE_X = 0.36;

    private static final double EYE_Y = 0.14;
    private static final double GAZE = 0.085;
    private static final double PUPIL = 0.115;
    private static final double GLINT = 0.042;
    private static final Color INK = Color.of(0x291715);

    private final Program program = new Program("face", "face");
    private final Baked sheet =
            new Baked(
                    "expression",
                    TEXELS,
                    TEXELS,
                    Expression.values().length,
                    Detail.FULL,
                    all -> {});

    /** Position, place on the sheet and its layer. */
    private final Triangles triangles = new Triangles(2, 3);

    private int count;

    FaceBatch() {
        sheet.shrink();
    }

    /** A face on a body, looking in a direction of the body's frame. */
    void add(Figure figure, OnScreen at, Mood mood, Gaze gaze, DotBatch pupils) {
        double wide = Math.min(OF_WIDTH * figure.halfWidth, OF_HEIGHT * figure.halfHeight);
        double unit = Math.min(MOST, wide);
        if (unit * at.scale() < LEAST) {
            return;
        }
        Expression expression = Expression.of(mood, count, gaze.seconds);
        count++;
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            int right = Triangles.SQUARE[i];
            int up = Triangles.SQUARE[i + 1];
            double reach = REACH * unit;
            at.vertex(triangles, right * reach, up * reach)
                    .put((1 + right) / 2f)
                    .put((1 + up) / 2f)
                    .put(expression.ordinal());
        }
        if (expression.isOpen()) {
            pupil(at, unit, EYE_X * unit, gaze, pupils);
            pupil(at, unit, -EYE_X * unit, gaze, pupils);
        }
    }

    private static void pupil(OnScreen at, double unit, double eyeX, Gaze gaze, DotBatch to) {
        double dx = gaze.x - at.worldX();
        double dy = gaze.y - at.worldY();
        double wander = GAZE * unit / Math.max(1e-9, Math.sqrt(dx * dx + dy * dy));
        double x = eyeX + wander * at.alongX(dx, dy);
        double y = EYE_Y * unit + wander * at.alongY(dx, dy);
        to.add(at, x, y, PUPIL * unit, INK);
        to.add(at, x - GLINT * unit, y + GLINT * unit, GLINT * unit, Color.TEXT);
    }

    void draw(Layout layout, double veil) {
        sheet.bind();
        program.use();
        program.set("veil", (float) veil);
        triangles.draw(program, layout);
        count = 0;
    }

    void free() {
        program.free();
        sheet.free();
        triangles.free();
    }
}
