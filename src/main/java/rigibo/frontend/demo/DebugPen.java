package rigibo.frontend.demo;

import rigibo.backend.ContactView;
import rigibo.backend.DebugDraw;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/**
 * The debug drawing of a demo: fixtures, contacts with their normals and forces, centres of mass,
 * and which bodies sleep. Shapes and joints are drawn by the scene itself.
 */
final class DebugPen implements DebugDraw {

    static final Layer[] LAYERS = {Layer.BOUNDS, Layer.CONTACTS, Layer.CENTRES};

    private static final double NORMAL_LENGTH_PX = 22;

    /**
     * Length of an arrow per square root of its force, px, so that weak forces show beside strong
     * ones.
     */
    private static final double FORCE_LENGTH_PX = 8;

    private static final double LONGEST_FORCE_PX = 120;

    private final Canvas canvas;
    private final Camera camera;
    private final double step;

    /** A pen for a pool whose steps are {@code step} seconds long. */
    DebugPen(Canvas canvas, Camera camera, double step) {
        this.canvas = canvas;
        this.camera = camera;
        this.step = step;
    }

    @Override
    public void bounds(RigidBody body, Aabb bounds) {
        if (!isInView(body)) {
            return;
        }
        double left = camera.screenX(bounds.minX);
        double top = camera.screenY(bounds.maxY);
        double width = camera.screenX(bounds.maxX) - left;
        double height = camera.screenY(bounds.minY) - top;
        canvas.frame(left, top, width, height, 0, Color.EDGE);
    }

    @Override
    public void contact(ContactView contact) {
        double force = contact.impulse / step;
        double length = Math.min(LONGEST_FORCE_PX, FORCE_LENGTH_PX * Math.sqrt(force));
        drawAlong(contact, length, 4, Color.BRASS);
        drawAlong(contact, NORMAL_LENGTH_PX, 1.5, Color.BAD);
        canvas.disc(camera.screenX(contact.x), camera.screenY(contact.y), 3, Color.BAD);
    }

    private void drawAlong(ContactView contact, double length, double width, Color color) {
        double x = camera.screenX(contact.x);
        double y = camera.screenY(contact.y);
        double tipX = x + length * contact.normalX;
        double tipY = y - length * contact.normalY;
        canvas.line(x, y, tipX, tipY, width, color);
    }

    @Override
    public void centre(RigidBody body, Look look) {
        if (isInView(body)) {
            Color color = look == Look.AWAKE ? Color.GOOD : Color.TEXT_DIM;
            canvas.disc(camera.screenX(body.x()), camera.screenY(body.y()), 3, color);
        }
    }

    private boolean isInView(RigidBody body) {
        return Workbench.isInView(canvas, camera, body);
    }
}
