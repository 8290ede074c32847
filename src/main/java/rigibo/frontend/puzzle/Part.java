package rigibo.frontend.puzzle;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;

/**
 * Something that is drawn like a body.
 *
 * @param x of its centre, m
 * @param y of its centre, m, up
 * @param angle rad, counter-clockwise
 */
record Part(Shape shape, double x, double y, double angle, Skin skin) {

    void draw(Canvas canvas) {
        canvas.body(shape, x, y, angle, skin, Canvas.Mood.PLAIN);
    }

    /** Finds the rectangle that it fills, m. */
    void bounds(Aabb out) {
        shape.bounds(x, y, Math.cos(angle), Math.sin(angle), out);
    }
}
