package rigibo.backend;

import rigibo.backend.geometry.MassProperties;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

/** What a body weighs: as was stated, else by its shape and its material. */
final class Weight {

    private Weight() {}

    /** Mass in kg and inertia in kg·m² about the centre of mass, whether bodies turn or not. */
    static MassProperties of(Bodies bodies, int slot) {
        return of(bodies, slot, bodies.shape[slot], bodies.material[slot]);
    }

    /** The same with another shape or material. */
    static MassProperties of(Bodies bodies, int slot, Shape shape, Material material) {
        BodyDefinition definition = BodyDefinition.fixed(shape).material(material);
        if (bodies.statedMass[slot] > 0) {
            definition = definition.mass(bodies.statedMass[slot]);
        }
        if (bodies.statedInertia[slot] > 0) {
            definition = definition.inertia(bodies.statedInertia[slot]);
        }
        return definition.massProperties();
    }
}
