package rigibo.lab.truth;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyDefinition;

/** The surroundings of most scenes: effects and ground. */
public final class Earth {

    /** Acceleration of gravity, m/s². */
    public static final double GRAVITY = 9.81;

    private Earth() {}

    /**
     * Gravity, contacts, rotation, friction, restitution and continuous impacts. Sleep is left out,
     * since a scene that rests only asleep does not rest.
     */
    public static Effects effects() {
        return Effects.usual().without(Sleep.class);
    }

    /** The effects without gravity. */
    public static Effects space() {
        return effects().without(Gravity.class);
    }

    /** A floor of 200 m with the surface y = 0, a friction and an elasticity. */
    public static BodyDefinition floor(double friction, double elasticity) {
        return Solid.fixed(200, 2, friction, elasticity).at(0, -1).name("floor");
    }
}
