package rigibo.backend.storage;

import static rigibo.backend.storage.Need.ALWAYS;
import static rigibo.backend.storage.Need.COMPOUNDS;
import static rigibo.backend.storage.Need.FRICTION;
import static rigibo.backend.storage.Need.ONE_SIDED;
import static rigibo.backend.storage.Need.RESTITUTION;
import static rigibo.backend.storage.Need.ROLLING_RESISTANCE;
import static rigibo.backend.storage.Role.DERIVED;
import static rigibo.backend.storage.Role.SAVED;
import static rigibo.backend.storage.Role.SCRATCH;

/**
 * The table of the pairs' columns, in the order in which they are saved. Apart from its field, a
 * column is declared by one line here.
 */
final class PairColumns {

    private PairColumns() {}

    /**
     * Passes every column to a visitor, and stores the array that the visitor returns in the field.
     */
    static void visit(Pairs p, ColumnVisitor v) {
        p.bodyA = v.column("bodyA", SAVED, ALWAYS, p.bodyA);
        p.bodyB = v.column("bodyB", SAVED, ALWAYS, p.bodyB);
        p.shapesA = v.column("shapesA", SAVED, COMPOUNDS, p.shapesA);
        p.shapesB = v.column("shapesB", SAVED, COMPOUNDS, p.shapesB);
        p.next = v.twins("next", SAVED, ALWAYS, p.next);
        p.previous = v.twins("previous", SAVED, ALWAYS, p.previous);
        visitManifold(p, v);
        visitForces(p, v);
        visitWhatIsTold(p, v);
        p.activeStep = v.column("activeStep", DERIVED, ALWAYS, p.activeStep);
    }

    private static void visitManifold(Pairs p, ColumnVisitor v) {
        p.normalX = v.column("normalX", SAVED, ALWAYS, p.normalX);
        p.normalY = v.column("normalY", SAVED, ALWAYS, p.normalY);
        p.faceOf = v.column("faceOf", SAVED, ALWAYS, p.faceOf);
        p.points = v.column("points", SAVED, ALWAYS, p.points);
        p.passage = v.column("passage", SAVED, ONE_SIDED, p.passage);
        p.beside = v.column("beside", SAVED, ONE_SIDED, p.beside);
        p.pointX = v.twins("pointX", SAVED, ALWAYS, p.pointX);
        p.pointY = v.twins("pointY", SAVED, ALWAYS, p.pointY);
        p.middleX = v.column("middleX", SAVED, ALWAYS, p.middleX);
        p.middleY = v.column("middleY", SAVED, ALWAYS, p.middleY);
        p.separation = v.twins("separation", SAVED, ALWAYS, p.separation);
        p.feature = v.twins("feature", SAVED, ALWAYS, p.feature);
        p.former = v.twins("former", SCRATCH, ALWAYS, p.former);
        // Unknown in a restored pool, which measures again with the same result.
        p.reach = v.column("reach", DERIVED, ALWAYS, p.reach);
    }

    private static void visitForces(Pairs p, ColumnVisitor v) {
        p.normalForce = v.twins("normalForce", SAVED, ALWAYS, p.normalForce);
        p.load = v.twins("load", SAVED, ALWAYS, p.load);
        p.friction = v.column("friction", DERIVED, FRICTION, p.friction);
        p.elasticity = v.column("elasticity", DERIVED, RESTITUTION, p.elasticity);
        p.frictionForce = v.column("frictionForce", SAVED, FRICTION, p.frictionForce);
        p.rollingTorque = v.column("rollingTorque", SAVED, ROLLING_RESISTANCE, p.rollingTorque);
    }

    /**
     * Whether a pair touched in this step also decides, in the next one, which bodies rest and what
     * is reported.
     */
    private static void visitWhatIsTold(Pairs p, ColumnVisitor v) {
        p.impulse = v.column("impulse", SAVED, ALWAYS, p.impulse);
        p.impacts = v.column("impacts", SAVED, ALWAYS, p.impacts);
        p.crushed = v.column("crushed", SAVED, ALWAYS, p.crushed);
        p.resting = v.column("resting", SAVED, ALWAYS, p.resting);
        p.touching = v.column("touching", SAVED, ALWAYS, p.touching);
        p.touchedBefore = v.column("touchedBefore", SAVED, ALWAYS, p.touchedBefore);
    }
}
