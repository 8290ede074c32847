package rigibo.frontend.draw;

import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

import java.nio.FloatBuffer;

/**
 * Filled rectangles with round corners. They cover most of a window besides its bodies; a shader
 * made only for them fills them four times as fast as NanoVG's.
 */
final class Plates {

    private final Program program = new Program("plate", "plate");

    private final Triangles triangles = PlateVertex.triangles();

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
            PlateVertex.put(to, wayX, wayY, halfWidth, halfHeight, rounded, color);
        }
    }

    /** Draws the plates that were added since the last call. */
    void draw(Layout layout) {
        triangles.draw(program, layout);
    }

    void free() {
        triangles.free();
        program.free();
    }
}
