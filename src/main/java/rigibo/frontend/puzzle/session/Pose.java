package rigibo.frontend.puzzle.session;

import rigibo.backend.RigidBody;

/**
 * The pose of a body.
 *
 * @param x m
 * @param y m, up
 * @param angle rad, counter-clockwise
 */
public record Pose(double x, double y, double angle) {

    static Pose of(RigidBody body) {
        return new Pose(body.x(), body.y(), body.angle());
    }

    /** The pose of a point (m) of the body's own frame, turned with the body. */
    public Pose at(double localX, double localY) {
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        return new Pose(x + cos * localX - sin * localY, y + sin * localX + cos * localY, angle);
    }

    /** The pose at a share, 0 to 1, of the way to another one. */
    Pose towards(Pose other, double share) {
        return new Pose(
                x + share * (other.x - x),
                y + share * (other.y - y),
                angle + share * (other.angle - angle));
    }
}
