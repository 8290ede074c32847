package rigibo.frontend.draw;

import rigibo.frontend.scene.Color;

import java.nio.FloatBuffer;

/**
 * Filled rectangles with round corners. They are most of what a window shows beside its bodies, and
 * a shader that knows nothing else fills them four times as fast as NanoVG's.
 */
final class Plates {

    private final Program program = new Program("plate", "plate");

    /** Position, way from the centre, half extents and corner, colour. */
    private final Triangles triangles = new Triangles(2, 2, 3, 4);

    /** A rectangle from its upper left corner, logical px. */
    void add(double x, double y, double width, double height, double corner, Color color) {
        double halfWidth = width / 2;
        double halfHeight = height / 2;
        double rounded = Math.min(corner, Math.min(halfWidth, halfHeight));
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            // Half a pixel more than the rectangle, for its smooth edge.
            double wayX = Triangles.SQUARE[i] * (halfWidth + 0.5);
            double wayY = Triangles.SQUARE[i + 1] * (halfHeight + 0.5);
            FloatBuffer to = triangles.vertex();
            to.put((float) (x + halfWidth + wayX)).put((float) (y + halfHeight + wayY));
            to.put((float) wayX).put((float) wayY);
            to.put((float) halfWidth).put((float) halfHeight).put((float) rounded);
            to.put(color.red()).put(color.green()).put(color.blue()).put(color.alpha());
        }
    }

    /** Draws what was added since. */
    void draw(float pixelRatio, double seconds) {
        triangles.draw(program, pixelRatio, seconds);
    }

    void free() {
        triangles.free();
        program.free();
    }
}
