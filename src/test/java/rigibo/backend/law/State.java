package rigibo.backend.law;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;

import java.util.stream.DoubleStream;

/**
 * Where a body is and how it moves.
 *
 * @param x m
 * @param y m
 * @param angle rad
 * @param velocityX m/s
 * @param velocityY m/s
 * @param spin rad/s
 */
record State(double x, double y, double angle, double velocityX, double velocityY, double spin) {

    static State of(RigidBody body) {
        return new State(
                body.x(),
                body.y(),
                body.angle(),
                body.velocityX(),
                body.velocityY(),
                body.angularVelocity());
    }

    static State of(BodyDefinition body) {
        return new State(
                body.x(), body.y(), body.angle(), body.velocityX(), body.velocityY(), body.spin());
    }

    /** The larger of the distance of the places in m and of the difference of the angles in rad. */
    double off(State other) {
        return Math.max(Math.hypot(x - other.x, y - other.y), Math.abs(angle - other.angle));
    }

    boolean isFinite() {
        return DoubleStream.of(x, y, angle, velocityX, velocityY, spin).allMatch(Double::isFinite);
    }

    /** Whether every number is the same; the two zeros are. */
    boolean isSame(State other) {
        return x == other.x
                && y == other.y
                && angle == other.angle
                && velocityX == other.velocityX
                && velocityY == other.velocityY
                && spin == other.spin;
    }
}
