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

/** Two discs 0.9 m apart; a stop counts if twice a step's way leads to it. */
class JointStopsTest {

    private static final double DT = 0.01;
    private static final double ROUND_OFF = 1e-12;

    private final FilledStorage storage =
            new FilledStorage(Accuracy.GAME, new Contacts(), new Rotation(), new Joints());
    private final JointStops stops = new JointStops(storage.data);
    private final JointStore joints = storage.data.joints;
    private int a;
    private int b;

    @BeforeEach
    void addDiscs() {
        a = storage.add(BodyDefinition.dynamic(new Circle(0.1)).at(0, 0).mass(1));
        b = storage.add(BodyDefinition.dynamic(new Circle(0.1)).at(0.9, 0).mass(1));
    }

    private int join(JointKind kind, double lower, double upper) {
        int joint = joints.add(kind, a, b);
        joints.lower[joint] = lower;
        joints.upper[joint] = upper;
        joints.elasticity[joint] = 0.5;
        return joint;
    }

    private void expect(int joint, double reach) {
        assertThat(stops.reach(joint, DT)).isCloseTo(reach, within(ROUND_OFF));
    }

    @Test
    void endOfARopeIsReachedWithinTwiceTheStep() {
        storage.bodies.velocityY[b] = 6;
        expect(join(JointKind.DISTANCE, 0, 1.01), 1.5 * 6 * DT);
        expect(join(JointKind.DISTANCE, 0, 1.03), 0);
    }

    @Test
    void limitsOfAHingeAreReachedByTurning() {
        storage.bodies.angle[b] = 0.4;
        storage.bodies.spin[b] = -7;
        storage.bodies.spin[a] = 2;
        int joint = join(JointKind.REVOLUTE, 0.3, 1);
        joints.anchorAX[joint] = 0.5;
        joints.anchorBX[joint] = -0.4;
        joints.axisA[joint] = 0.1;
        joints.axisB[joint] = 0.15;
        expect(joint, 1.5 * (2 * 0.5 + 7 * 0.4) * DT);
        joints.lower[joint] = 0.2;
        expect(joint, 0);
    }

    /** The slider is 0.9 − 0.2 along an axis that has turned with A. */
    @Test
    void limitsOfASliderLieAlongItsAxis() {
        storage.bodies.velocityX[b] = 4;
        storage.bodies.cos[a] = 0.8;
        storage.bodies.sin[a] = 0.6;
        int joint = join(JointKind.PRISMATIC, 0, 0.76);
        joints.axisA[joint] = -Math.atan2(0.6, 0.8);
        joints.anchorBX[joint] = -0.2;
        expect(joint, 1.5 * 4 * DT);
        joints.upper[joint] = 0.79;
        expect(joint, 0);
        joints.lower[joint] = 0.63;
        expect(joint, 1.5 * 4 * DT);
    }

    @Test
    void whatHasNoStopsStrikesNone() {
        storage.bodies.velocityX[b] = 100;
        expect(join(JointKind.DISTANCE, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY), 0);
        expect(join(JointKind.REVOLUTE, 0.4, 0.4), 0);
    }
}
