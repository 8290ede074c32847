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

    /** The distance by which pupils move, and their size. */
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
                    FaceForm.values().length * Expression.values().length,
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
        FaceForm form = FaceForm.of(figure);
        double unit = form.unit(figure);
        if (unit * at.scale() < LEAST) {
            return;
        }
        Expression expression = Expression.of(mood, count, gaze.seconds);
        count++;
        int layer = form.ordinal() * Expression.values().length + expression.ordinal();
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            int right = Triangles.SQUARE[i];
            int up = Triangles.SQUARE[i + 1];
            double reach = form.reach * unit;
            at.vertex(triangles, right * reach, up * reach)
                    .put((1 + right) / 2f)
                    .put((1 + up) / 2f)
                    .put(layer);
        }
        if (expression.isOpen()) {
            double eyeY = form.eyeY * unit;
            pupil(at, unit, form.eyeX * unit, eyeY, gaze, pupils);
            pupil(at, unit, -form.eyeX * unit, eyeY, gaze, pupils);
        }
    }

    private static void pupil(
            OnScreen at, double unit, double eyeX, double eyeY, Gaze gaze, DotBatch to) {
        double dx = gaze.x - at.worldX();
        double dy = gaze.y - at.worldY();
        double wander = GAZE * unit / Math.max(1e-9, Math.sqrt(dx * dx + dy * dy));
        double x = eyeX + wander * at.alongX(dx, dy);
        double y = eyeY + wander * at.alongY(dx, dy);
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
