package rigibo.lab.hardcase;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Earth;

/**
 * The effects and the ground that most cases share. Sleep is never among them: a scene that only
 * rests because it is put to sleep does not rest.
 */
final class Surroundings {

    private Surroundings() {}

    /** Weight, contacts, rotation, friction, elasticity, impacts at their time. */
    static Effects earth() {
        return Earth.effects();
    }

    /** The same without weight. */
    static Effects space() {
        return earth().without(Gravity.class);
    }

    /** A floor of 200 m whose surface is y = 0, of this friction and elasticity. */
    static BodyDefinition floor(double friction, double elasticity) {
        return Earth.floor(friction, elasticity);
    }

    /** Density 1. */
    static Material matter(double friction, double elasticity) {
        return new Material(1, friction, elasticity);
    }
}
