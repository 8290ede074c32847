package rigibo.backend;

import rigibo.backend.geometry.Placement;
import rigibo.backend.setup.Require;

/**
 * The motion of a shape for {@link Geometry#timeOfImpact}: constant velocity and angular velocity
 * from a starting pose.
 *
 * <pre>{@code
 * Movement thrown = new Movement(Placement.at(0, 1), 4, 2, 6); // 4 m/s, 2 m/s up, 6 rad/s
 * }</pre>
 *
 * @param from the pose at time 0
 * @param velocityX m/s, to the right
 * @param velocityY m/s, up
 * @param angularVelocity rad/s, counter-clockwise
 */
public record Movement(Placement from, double velocityX, double velocityY, double angularVelocity) {

    /**
     * Checks every number.
     *
     * @throws IllegalArgumentException naming the one that is not finite
     */
    public Movement {
        Require.present("Movement.from", from);
        Require.finite("Movement.velocityX", velocityX, "m/s");
        Require.finite("Movement.velocityY", velocityY, "m/s");
        Require.finite("Movement.angularVelocity", angularVelocity, "rad/s");
    }
}
