package rigibo.backend;

import rigibo.backend.geometry.MassProperties;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

/**
 * Mass and inertia of a body: as stated, otherwise from its shape and material. A body that is not
 * dynamic, or whose rotation is locked, keeps both numbers; only the inverses are 0.
 */
final class Weight {

    private Weight() {}

    /** Mass in kg and inertia in kg·m² about the centre of mass, whether bodies turn or not. */
    static MassProperties of(Bodies bodies, int slot) {
        return of(bodies, slot, bodies.shape[slot], bodies.material[slot]);
    }

    /** Mass and inertia that the body would have with another shape or material. */
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

    /** Writes the columns of mass and inertia. */
    static void write(Bodies bodies, int slot) {
        write(bodies, slot, of(bodies, slot));
    }

    /** Writes the columns of mass and inertia from known values. */
    static void write(Bodies bodies, int slot, MassProperties plate) {
        boolean moves = bodies.type[slot] == BodyType.DYNAMIC;
        bodies.mass[slot] = plate.mass();
        bodies.inverseMass[slot] = moves ? 1 / plate.mass() : 0;
        if (bodies.turns()) {
            bodies.inertia[slot] = plate.inertia();
            boolean turns = moves && !bodies.isRotationLocked(slot);
            bodies.inverseInertia[slot] = turns ? 1 / plate.inertia() : 0;
        }
    }
}
