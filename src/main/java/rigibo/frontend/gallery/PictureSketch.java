package rigibo.frontend.gallery;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;

/** The sketch of an exhibit on its card, reduced to parts wholly inside the picture. */
final class PictureSketch implements Sketch {

    private final Sketch beyond;
    private final Aabb window;
    private final Aabb own = new Aabb();

    /** A sketch that passes on to another one only what lies within a rectangle of the world, m. */
    PictureSketch(Sketch beyond, Aabb window) {
        this.beyond = beyond;
        this.window = window;
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, Tone tone) {
        if (window.contains(x1, y1) && window.contains(x2, y2)) {
            beyond.line(x1, y1, x2, y2, tone);
        }
    }

    @Override
    public void point(double x, double y, Tone tone) {
        if (window.contains(x, y)) {
            beyond.point(x, y, tone);
        }
    }

    @Override
    public void shape(Shape shape, Placement at) {
        shape.bounds(at.x(), at.y(), Math.cos(at.angle()), Math.sin(at.angle()), own);
        if (window.contains(own.minX, own.minY) && window.contains(own.maxX, own.maxY)) {
            beyond.shape(shape, at);
        }
    }

    /** There is no room for letters. */
    @Override
    public void count(String figure) {}
}
