package rigibo.frontend.puzzle.picture;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;

/**
 * An object drawn like a body.
 *
 * @param x of its centre, m
 * @param y of its centre, m, up
 * @param angle rad, counter-clockwise
 */
public record Part(Shape shape, double x, double y, double angle, Skin skin) {

    /** A body at its start. */
    static Part of(LevelBody body) {
        return new Part(body.shape(), body.x(), body.y(), body.angle(), Skins.of(body.substance()));
    }

    /** Draws it; parts drawn later are in front of it. */
    public void draw(Canvas canvas) {
        canvas.body(shape, x, y, angle, skin, Canvas.Mood.PLAIN);
    }

    /** Writes its bounding rectangle, m. */
    void bounds(Aabb out) {
        shape.bounds(x, y, Math.cos(angle), Math.sin(angle), out);
    }

    /** Whether it hides a point of the world, m. A chain, which is a line, hides none. */
    boolean covers(double px, double py) {
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        double own = cos * (px - x) + sin * (py - y);
        double up = cos * (py - y) - sin * (px - x);
        for (int part = 0; part < shape.parts(); part++) {
            Outline outline = shape.outline(part);
            if (!outline.isEdge() && outline.depth(own, up) > 0) {
                return true;
            }
        }
        return false;
    }
}
