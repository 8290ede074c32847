package rigibo.backend;

import rigibo.backend.geometry.MassProperties;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

/**
 * What a body weighs: as was stated, else by its shape and its material. What is not dynamic or
 * kept from turning has its mass and inertia all the same, and inverses of 0.
 */
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

    /** Writes the columns of mass as the body weighs. */
    static void write(Bodies bodies, int slot) {
        write(bodies, slot, of(bodies, slot));
    }

    /** Writes the columns of mass, where what the body weighs is known. */
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
