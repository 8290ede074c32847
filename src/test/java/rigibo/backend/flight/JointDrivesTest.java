package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.JointStore;

/** Two discs 0.9 m apart, of 2 kg and 0.5 kg: ways of F/m·t²/2 and of v·t. */
class JointDrivesTest {

    private static final double DT = 0.01;
    private static final double FALL = DT * DT / 2;
    private static final double RADIUS = 0.1;
    private static final double ROUND_OFF = 1e-15;

    private final FilledStorage storage =
            new FilledStorage(Accuracy.GAME, new Contacts(), new Rotation(), new Joints());
    private final JointDrives drives = new JointDrives(storage.data);
    private final JointStore joints = storage.data.joints;
    private int a;
    private int b;

    @BeforeEach
    void addDiscs() {
        a = storage.add(BodyDefinition.dynamic(new Circle(RADIUS)).at(0, 0).mass(2));
        b = storage.add(BodyDefinition.dynamic(new Circle(RADIUS)).at(0.9, 0).mass(0.5));
    }

    private void expect(int joint, int slot, double way) {
        assertThat(drives.way(joint, slot, DT)).isCloseTo(way, within(ROUND_OFF));
    }

    private int spring(JointKind kind, double stiffness) {
        int joint = joints.add(kind, a, b);
        joints.stiffness[joint] = stiffness;
        return joint;
    }

    @Test
    void aSpringDrawsTheLighterBodyFarther() {
        int joint = spring(JointKind.DISTANCE, 300);
        joints.parameter[JointStore.LENGTH][joint] = 0.4;
        expect(joint, a, 300 * 0.5 / 2 * FALL);
        expect(joint, b, 300 * 0.5 / 0.5 * FALL);
    }

    /** Of 0.5 m it swings to 0.5 m on the other side. */
    @Test
    void aStiffSpringDrawsNoFartherThanItSwings() {
        int joint = spring(JointKind.DISTANCE, 1e9);
        joints.parameter[JointStore.LENGTH][joint] = 0.4;
        expect(joint, b, 1);
    }

    /** A twist of 0.2 rad, about an anchor 0.3 m from the centre of a disc of 0.1 m. */
    @Test
    void aTwistedHingeTurnsTheOutline() {
        int joint = spring(JointKind.REVOLUTE, 7);
        storage.bodies.angle[b] = 0.2;
        joints.anchorBX[joint] = -0.3;
        double inertia = 0.5 * RADIUS * RADIUS / 2;
        expect(joint, b, 7 * 0.2 / inertia * FALL * (0.3 + RADIUS));
    }

    /** A hand at 2 m holds B alone, with at most 5 N. */
    @Test
    void aHandDrawsItsBodyWithItsGreatestForce() {
        int joint = spring(JointKind.MOUSE, 100);
        joints.parameter[JointStore.TARGET_X][joint] = 2.9;
        joints.parameter[JointStore.MOST_FORCE][joint] = 5;
        expect(joint, b, 5 / 0.5 * FALL);
        expect(joint, a, 0);
        joints.parameter[JointStore.MOST_FORCE][joint] = 1000;
        expect(joint, b, 100 * 2 / 0.5 * FALL);
    }

    @Test
    void aMotorDrivesUpToItsSpeed() {
        int joint = joints.add(JointKind.PRISMATIC, a, b);
        joints.motorMost[joint] = 30;
        joints.motorSpeed[joint] = 4;
        storage.bodies.velocityX[b] = 1;
        expect(joint, b, 30 / 0.5 * FALL);
        joints.motorMost[joint] = 1e6;
        expect(joint, b, 3 * DT);
        storage.bodies.velocityX[b] = 4;
        expect(joint, b, 0);
    }

    /** 20 rad/s of which the wheel turns at 5. */
    @Test
    void aWheelIsTurned() {
        int joint = joints.add(JointKind.WHEEL, a, b);
        joints.motorMost[joint] = 1e6;
        joints.motorSpeed[joint] = 20;
        storage.bodies.spin[b] = 5;
        expect(joint, b, 15 * RADIUS * DT);
    }

    @Test
    void whatCannotMoveOrIsNotDrivenGoesNowhere() {
        int fixed = storage.add(BodyDefinition.fixed(new Circle(RADIUS)).at(0, 1));
        int joint = joints.add(JointKind.DISTANCE, fixed, b);
        expect(joint, b, 0);
        joints.stiffness[joint] = 100;
        expect(joint, fixed, 0);
        assertThat(drives.way(joint, b, DT)).isPositive();
    }
}
