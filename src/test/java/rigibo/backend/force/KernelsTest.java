package rigibo.backend.force;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;

/**
 * Forces that are constant during a step. Numbers are small whole ones and halves: products and
 * sums are exact.
 */
class KernelsTest {

    private static final double DT = 1.0 / 60;

    private final Gravity gravity = new Gravity(2, -8);
    private final Wind wind = new Wind(6, -2);
    private final DataStorage data =
            new DataStorage(Effects.of(gravity, new Rotation(), new Thrust(), new Drag(), wind));
    private final Bodies bodies = data.bodies;

    private final int first = body(BodyType.DYNAMIC);
    private final int sleeper = body(BodyType.DYNAMIC);
    private final int driven = body(BodyType.KINEMATIC);
    private final int floor = body(BodyType.STATIC);
    private final int second = body(BodyType.DYNAMIC);

    KernelsTest() {
        bodies.awake[sleeper] = false;
        bodies.velocityX[driven] = 1;
        data.roster.refresh(bodies);
    }

    /** Of 2 kg and 4 kg·m², with accelerations of 1, 2 and 3 from elsewhere. */
    private int body(BodyType type) {
        int slot = bodies.take();
        bodies.type[slot] = type;
        bodies.awake[slot] = true;
        bodies.inverseMass[slot] = type == BodyType.DYNAMIC ? 0.5 : 0;
        bodies.inverseInertia[slot] = type == BodyType.DYNAMIC ? 0.25 : 0;
        bodies.gravityScale[slot] = 1;
        bodies.drag[slot] = 0.5;
        bodies.accelerationX[slot] = 1;
        bodies.accelerationY[slot] = 2;
        bodies.angularAcceleration[slot] = 3;
        return slot;
    }

    private void require(int slot, double x, double y, double turn) {
        assertThat(bodies.accelerationX[slot]).as("x of %s", slot).isEqualTo(x);
        assertThat(bodies.accelerationY[slot]).as("y of %s", slot).isEqualTo(y);
        assertThat(bodies.angularAcceleration[slot]).as("turn of %s", slot).isEqualTo(turn);
    }

    private void requireUntouched(int... slots) {
        for (int slot : slots) {
            require(slot, 1, 2, 3);
        }
    }

    @Test
    void gravityPullsWhatIsDynamicAndAwakeByItsScale() {
        bodies.gravityScale[second] = -0.5;
        new GravityKernel(data, gravity).accelerate(DT);

        require(first, 1 + 2, 2 - 8, 3);
        require(second, 1 - 1, 2 + 4, 3);
        requireUntouched(sleeper, driven, floor);
    }

    @Test
    void windImpactsByTheDrag() {
        bodies.drag[second] = 2;
        new WindKernel(data, wind).accelerate(DT);

        require(first, 1 + 3, 2 - 1, 3);
        require(second, 1 + 12, 2 - 4, 3);
        requireUntouched(sleeper, driven, floor);
    }

    private void ask(int slot, double forceX, double forceY, double torque) {
        bodies.forceX[slot] = forceX;
        bodies.forceY[slot] = forceY;
        bodies.torque[slot] = torque;
        data.thrusting.add(slot);
    }

    @Test
    void thrustIsForceByMassAndTorqueByInertia() {
        ask(first, 8, -6, 12);
        ask(second, 2, 4, -4);
        new ThrustKernel(data, new TorqueKernel(data)).accelerate(DT);

        require(first, 1 + 4, 2 - 3, 3 + 3);
        require(second, 1 + 1, 2 + 2, 3 - 1);
        requireUntouched(sleeper, driven, floor);
    }

    /** Asked for twice, a body is on the list twice; the forces are in one sum. */
    @Test
    void aForceActsOnceAndInOneStepOnly() {
        ask(first, 8, -6, 12);
        data.thrusting.add(first);
        ThrustKernel thrust = new ThrustKernel(data, new TorqueKernel(data));
        thrust.accelerate(DT);
        thrust.accelerate(DT);

        require(first, 1 + 4, 2 - 3, 3 + 3);
        assertThat(bodies.isThrust(first)).isFalse();
        assertThat(data.thrusting.count).isZero();
    }

    /** The list is what a step before left it, beyond its count. */
    @Test
    void onlyWhatIsOnTheListIsPushed() {
        ask(second, 2, 4, -4);
        data.thrusting.numbers[1] = first;
        bodies.forceX[first] = 8;
        bodies.torque[first] = 8;
        new ThrustKernel(data, new TorqueKernel(data)).accelerate(DT);

        requireUntouched(first);
    }

    /** A body may have been made kinematic since, with its old mass: the force goes nowhere. */
    @Test
    void aForceOnWhatIsNoLongerDynamicIsForgotten() {
        bodies.inverseMass[driven] = 0.5;
        bodies.inverseInertia[driven] = 0.25;
        ask(driven, 8, -6, 12);
        new ThrustKernel(data, new TorqueKernel(data)).accelerate(DT);

        requireUntouched(driven);
        assertThat(bodies.isThrust(driven)).isFalse();
    }

    @Test
    void withoutRotationForcesActAlone() {
        ask(first, 8, -6, 0);
        new ThrustKernel(data, null).accelerate(DT);

        require(first, 1 + 4, 2 - 3, 3);
        assertThat(data.thrusting.count).isZero();
    }
}
