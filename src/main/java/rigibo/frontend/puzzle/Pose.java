package rigibo.frontend.puzzle;

import rigibo.backend.RigidBody;

/**
 * The pose of a body.
 *
 * @param x m
 * @param y m, up
 * @param angle rad, counter-clockwise
 */
record Pose(double x, double y, double angle) {

    static Pose of(RigidBody body) {
        return new Pose(body.x(), body.y(), body.angle());
    }

    /** The pose at a share, 0 to 1, of the way to another one. */
    Pose towards(Pose other, double share) {
        return new Pose(
                x + share * (other.x - x),
                y + share * (other.y - y),
                angle + share * (other.angle - angle));
    }
}
