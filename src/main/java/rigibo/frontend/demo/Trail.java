package rigibo.frontend.demo;

import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** The path of a point in the last seconds, fading. */
final class Trail {

    private static final int KEPT = 240;

    /** Number of curves in which the path fades, since a curve has one colour. */
    private static final int CURVES = 8;

    private final double[] xy = new double[2 * KEPT];
    private final double[] screen = new double[2 * KEPT];
    private int count;

    void add(double x, double y) {
        int at = count % KEPT;
        xy[2 * at] = x;
        xy[2 * at + 1] = y;
        count++;
    }

    void clear() {
        count = 0;
    }

    void draw(Camera camera, Canvas canvas, Color color) {
        int kept = Math.min(count, KEPT);
        int each = Math.max(2, kept / CURVES);
        for (int first = 0; first + 1 < kept; first += each) {
            int points = Math.min(each + 1, kept - first);
            for (int i = 0; i < points; i++) {
                int at = (count - kept + first + i) % KEPT;
                screen[2 * i] = camera.screenX(xy[2 * at]);
                screen[2 * i + 1] = camera.screenY(xy[2 * at + 1]);
            }
            double share = (first + points) / (double) kept;
            canvas.curve(screen, points, 2.5, color.alpha(0.7 * share));
        }
    }
}
