package rigibo.backend.saved;

import org.junit.jupiter.api.Test;

import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.JointStore;

import java.util.function.Consumer;

/** Snapshots that are well written but state joints that no pool can have are refused. */
class JointContentTest {

    /** Two wheels on a frame, geared: joints 0, 1 and the gear 2; bodies 0, 1 and 2. */
    private static Snapshot snapshot() {
        Pool pool = new Pool(Effects.usual().with(new Joints()), Accuracy.GAME);
        RigidBody frame = pool.add(BodyDefinition.fixed(Polygon.box(4, 0.1)));
        RigidBody one = pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(-1, 0));
        RigidBody two = pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(1, 0));
        Joint first = pool.join(RevoluteJoint.at(frame, one, -1, 0));
        Joint second = pool.join(RevoluteJoint.at(frame, two, 1, 0));
        pool.join(GearJoint.of(first, second, 2));
        pool.step(1.0 / 60);
        return Snapshot.decode(pool.snapshot(), revision -> {});
    }

    private static void requireRefusal(Consumer<JointStore> change, String words) {
        Snapshot snapshot = snapshot();
        change.accept(snapshot.data.joints);
        SnapshotContentTest.requireRefusal(snapshot, words);
    }

    @Test
    void unknownKindIsRefused() {
        requireRefusal(joints -> joints.kind[0] = 99, "kind");
        requireRefusal(joints -> joints.kind[0] = -1, "kind");
    }

    @Test
    void bodyOutOfRangeIsRefused() {
        requireRefusal(joints -> joints.bodyA[0] = 3, "must hold bodies, was slot 3");
        requireRefusal(joints -> joints.bodyB[1] = -1, "must hold bodies, was slot -1");
        requireRefusal(joints -> joints.bodyB[0] = 0, "must hold two bodies");
    }

    @Test
    void gearOfOtherJointsIsRefused() {
        requireRefusal(joints -> joints.firstGeared[2] = 7, "must couple a joint");
        requireRefusal(joints -> joints.secondGeared[2] = -1, "must couple a joint");
        requireRefusal(joints -> joints.secondGeared[2] = 0, "must couple a joint");
    }

    @Test
    void numberThatIsNotFiniteIsRefused() {
        requireRefusal(joints -> joints.parameter[0][2] = Double.NaN, "parameter");
        requireRefusal(joints -> joints.force[0][0] = Double.POSITIVE_INFINITY, "force");
        requireRefusal(joints -> joints.reactionX[0] = Double.NaN, "reactionX");
        requireRefusal(joints -> joints.stiffness[0] = -1, "stiffness");
        requireRefusal(joints -> joints.anchorAX[0] = Double.NaN, "JointFrame.x");
        requireRefusal(joints -> joints.lower[0] = Double.NaN, "JointLimits");
    }

    @Test
    void orderThatMissesAJointIsRefused() {
        Snapshot tooFew = snapshot();
        tooFew.jointOrder = new int[] {0, 1};
        SnapshotContentTest.requireRefusal(tooFew, "must name 3 joints, was 2");
        Snapshot twice = snapshot();
        twice.jointOrder = new int[] {0, 1, 1};
        SnapshotContentTest.requireRefusal(twice, "each joint once, was slot 1");
    }
}
