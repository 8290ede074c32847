package rigibo.lab.hardcase;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * The effects and the ground that most cases share. Sleep is never among them: a scene that only
 * rests because it is put to sleep does not rest.
 */
final class Surroundings {

    private Surroundings() {}

    /** Weight, contacts, rotation, friction, elasticity, impacts at their time. */
    static Effects earth() {
        return space().with(new Gravity(0, -Trial.GRAVITY));
    }

    /** The same without weight. */
    static Effects space() {
        return Effects.of(
                new Contacts(),
                new Rotation(),
                new Friction(),
                new Restitution(),
                new ContinuousImpacts());
    }

    /** A floor of 200 m whose surface is y = 0, of this friction and elasticity. */
    static BodyDefinition floor(double friction, double elasticity) {
        return BodyDefinition.fixed(Polygon.box(200, 2))
                .at(0, -1)
                .material(matter(friction, elasticity))
                .name("floor");
    }

    /** Density 1. */
    static Material matter(double friction, double elasticity) {
        return new Material(1, friction, elasticity);
    }
}
