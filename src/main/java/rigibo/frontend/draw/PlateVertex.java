package rigibo.frontend.draw;

import rigibo.frontend.scene.Color;

import java.nio.FloatBuffer;

/** The vertices of rectangles with round corners, and of discs, which are nothing but corners. */
final class PlateVertex {

    private PlateVertex() {}

    /** Triangles for the plates' program: position, way from the centre, extents, colour. */
    static Triangles triangles() {
        return new Triangles(2, 2, 3, 4);
    }

    /**
     * The attributes of a vertex after its position: offset from the centre, extents of the plate,
     * colour.
     */
    static void put(
            FloatBuffer to,
            double wayX,
            double wayY,
            double halfWidth,
            double halfHeight,
            double corner,
            Color color) {
        to.put((float) wayX).put((float) wayY);
        to.put((float) halfWidth).put((float) halfHeight).put((float) corner);
        to.put(color.red()).put(color.green()).put(color.blue()).put(color.alpha());
    }
}
