package rigibo.backend.storage;

import static rigibo.backend.storage.Need.ALWAYS;
import static rigibo.backend.storage.Role.SAVED;

/** The table of the joints' columns, in the order in which they are saved. */
final class JointColumns {

    private JointColumns() {}

    /**
     * Passes every column to a visitor, and stores the array that the visitor returns in the field.
     */
    static void visit(JointStore j, ColumnVisitor v) {
        j.kind = v.column("joint kind", SAVED, ALWAYS, j.kind);
        j.bodyA = v.column("joint bodyA", SAVED, ALWAYS, j.bodyA);
        j.bodyB = v.column("joint bodyB", SAVED, ALWAYS, j.bodyB);
        j.firstGeared = v.column("firstGeared", SAVED, ALWAYS, j.firstGeared);
        j.secondGeared = v.column("secondGeared", SAVED, ALWAYS, j.secondGeared);
        j.meets = v.column("meets", SAVED, ALWAYS, j.meets);
        visitPlace(j, v);
        visitSettings(j, v);
        visitCarried(j, v);
    }

    private static void visitPlace(JointStore j, ColumnVisitor v) {
        j.anchorAX = v.column("anchorAX", SAVED, ALWAYS, j.anchorAX);
        j.anchorAY = v.column("anchorAY", SAVED, ALWAYS, j.anchorAY);
        j.axisA = v.column("axisA", SAVED, ALWAYS, j.axisA);
        j.anchorBX = v.column("anchorBX", SAVED, ALWAYS, j.anchorBX);
        j.anchorBY = v.column("anchorBY", SAVED, ALWAYS, j.anchorBY);
        j.axisB = v.column("axisB", SAVED, ALWAYS, j.axisB);
        for (int i = 0; i < JointStore.PARAMETERS; i++) {
            j.parameter[i] = v.column("parameter " + i, SAVED, ALWAYS, j.parameter[i]);
        }
    }

    private static void visitSettings(JointStore j, ColumnVisitor v) {
        j.lower = v.column("lower", SAVED, ALWAYS, j.lower);
        j.upper = v.column("upper", SAVED, ALWAYS, j.upper);
        j.elasticity = v.column("joint elasticity", SAVED, ALWAYS, j.elasticity);
        j.motorSpeed = v.column("motorSpeed", SAVED, ALWAYS, j.motorSpeed);
        j.motorMost = v.column("motorMost", SAVED, ALWAYS, j.motorMost);
        j.hertz = v.column("hertz", SAVED, ALWAYS, j.hertz);
        j.dampingRatio = v.column("dampingRatio", SAVED, ALWAYS, j.dampingRatio);
        j.stiffness = v.column("stiffness", SAVED, ALWAYS, j.stiffness);
        j.damping = v.column("damping", SAVED, ALWAYS, j.damping);
        j.breakForce = v.column("breakForce", SAVED, ALWAYS, j.breakForce);
        j.breakTorque = v.column("breakTorque", SAVED, ALWAYS, j.breakTorque);
    }

    private static void visitCarried(JointStore j, ColumnVisitor v) {
        for (int i = 0; i < JointStore.ROWS; i++) {
            j.force[i] = v.column("force " + i, SAVED, ALWAYS, j.force[i]);
        }
        j.reactionX = v.column("reactionX", SAVED, ALWAYS, j.reactionX);
        j.reactionY = v.column("reactionY", SAVED, ALWAYS, j.reactionY);
        j.reactionTurn = v.column("reactionTurn", SAVED, ALWAYS, j.reactionTurn);
        j.pull = v.column("pull", SAVED, ALWAYS, j.pull);
    }
}
