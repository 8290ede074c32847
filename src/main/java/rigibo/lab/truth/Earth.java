package rigibo.lab.truth;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyDefinition;

/** The surroundings of most scenes: the effects on the ground, and the ground. */
public final class Earth {

    /** Acceleration of gravity, m/s². */
    public static final double GRAVITY = 9.81;

    private Earth() {}

    /**
     * Weight, contacts, rotation, friction, elasticity, impacts at their time. Sleep is not among
     * them: a scene that only rests because it is put to sleep does not rest.
     */
    public static Effects effects() {
        return Effects.usual().without(Sleep.class);
    }

    /** The effects of Earth but for gravity. */
    public static Effects space() {
        return effects().without(Gravity.class);
    }

    /** A floor of 200 m whose surface is y = 0, of this friction and elasticity. */
    public static BodyDefinition floor(double friction, double elasticity) {
        return Solid.fixed(200, 2, friction, elasticity).at(0, -1).name("floor");
    }
}
