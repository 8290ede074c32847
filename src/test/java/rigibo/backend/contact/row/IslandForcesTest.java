package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldFunction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.force.Instant;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/** Forces that vary along the path, for packed bodies at their present places. */
class IslandForcesTest {

    private static final double ROUND_OFF = 1e-12;

    private final Motions motions = new Motions(true);
    private StoredIsland island;
    private IslandForces forces;
    private PackedTurns turns;

    private void declare(FieldFunction function) {
        declare(Effects.of(new Contacts(), new Rotation(), new Field(function)));
    }

    private void declare(Effects effects) {
        island = new StoredIsland(effects);
        island.bodies.integratePaths(true);
        forces = new IslandForces(island.data, new ChangingForces(effects));
        turns = new PackedTurns(island.bodies, motions);
    }

    private int body(BodyDefinition definition) {
        int slot = island.body(definition.mass(2));
        motions.clear(island.bodies);
        motions.offset(island.bodies, slot);
        island.bodies.accelerationX[slot] = 7;
        island.bodies.accelerationY[slot] = 8;
        island.bodies.angularAcceleration[slot] = 9;
        return slot;
    }

    private void set(int column, double value) {
        motions.data[Motions.STRIDE + column] = value;
    }

    /**
     * The force field is given the place and velocity in the world, although the frame moves; and
     * mass and time.
     */
    @Test
    void forceIsThatOfThePresentPlace() {
        declare(
                at -> {
                    assertThat(at.x).isCloseTo(1 + 0.25 + 0.3 * 2, within(ROUND_OFF));
                    assertThat(at.y).isCloseTo(5 + 0.5 - 0.3 * 3, within(ROUND_OFF));
                    assertThat(at.mass).isEqualTo(2);
                    assertThat(at.time).isCloseTo(10.3, within(ROUND_OFF));
                    at.push(4, -6);
                });
        int slot = body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(1, 5));
        island.data.time = 10;
        set(Motions.DX, 0.25);
        set(Motions.DY, 0.5);
        motions.takeFrame(2, -3);
        forces.refresh(motions, turns, 0.3, 0);
        assertThat(island.bodies.pullX[slot]).isEqualTo(2);
        assertThat(island.bodies.pullY[slot]).isEqualTo(-3);
        assertThat(island.bodies.accelerationX[slot]).isEqualTo(9);
        assertThat(island.bodies.accelerationY[slot]).isEqualTo(5);
        assertThat(forces.change()).isEqualTo(5);
        // The next evaluation takes the place of this one, which has not changed.
        forces.refresh(motions, turns, 0.3, 0);
        assertThat(island.bodies.accelerationX[slot]).isEqualTo(9);
        assertThat(forces.change()).isZero();
    }

    /**
     * With −k·v and k·h above 1 the velocity would be reversed: the share 1/(k·h) stops the body.
     * The velocity is that in the world.
     */
    @ParameterizedTest
    @CsvSource({"2, 0.25", "4, 0.25", "8, 0.25", "400, 0.25"})
    void dragDoesNotThrowBack(double k, double h) {
        declare(at -> at.accelerate(-k * at.velocityX, -k * at.velocityY));
        int slot = body(BodyDefinition.dynamic(Polygon.box(1, 1)));
        set(Motions.VX, 3);
        set(Motions.VY, -1);
        motions.takeFrame(1, 2);
        forces.refresh(motions, turns, 0, h);
        double share = 1 / Math.max(1, k * h);
        assertThat(island.bodies.pullX[slot]).isCloseTo(-k * 4 * share, within(1e-10));
        assertThat(island.bodies.pullY[slot]).isCloseTo(-k * share, within(1e-10));
        double changed = k * 4 * share + k * share;
        assertThat(forces.change()).isCloseTo(changed, within(1e-10));
    }

    /** A force that accelerates the body is applied in full. */
    @Test
    void whatSpeedsUpIsNotBraked() {
        declare(at -> at.accelerate(9 * at.velocityX, 0));
        int slot = body(BodyDefinition.dynamic(Polygon.box(1, 1)));
        set(Motions.VX, 2);
        forces.refresh(motions, turns, 0, 1);
        assertThat(island.bodies.pullX[slot]).isEqualTo(18);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e300, Double.NaN, Double.POSITIVE_INFINITY})
    void forceThatIsNoNumberIsNotTaken(double force) {
        declare(at -> at.push(force, 0));
        int slot = body(BodyDefinition.dynamic(Polygon.box(1, 1)));
        forces.refresh(motions, turns, 0, 0.1);
        assertThat(island.bodies.pullX[slot]).isZero();
        assertThat(island.bodies.accelerationX[slot]).isEqualTo(7);
    }

    @Test
    void drivenBodiesAreNotPushed() {
        declare(at -> at.push(1, 1));
        int slot = body(BodyDefinition.kinematic(Polygon.box(1, 1)).velocity(1, 0));
        forces.refresh(motions, turns, 0, 0.1);
        assertThat(island.bodies.pullX[slot]).isZero();
    }

    /** Water lifts and turns a tilted box as in flight, at its present place. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void waterTurnsWhatIsTilted(boolean isPacked) {
        Effects effects =
                Effects.of(
                        new Contacts(),
                        new Rotation(),
                        new Gravity(0, -9.81),
                        new Buoyancy(0, 2, 0));
        declare(effects);
        int slot = body(BodyDefinition.dynamic(Polygon.box(2, 1)).angle(0.2).at(0, 0.3));
        set(Motions.DY, -0.2);
        set(Motions.TURN, 0.3);
        forces.refresh(motions, isPacked ? turns : null, 0, 1e-6);
        Instant truth = new Instant();
        truth.take(island.bodies, slot);
        truth.y = 0.1;
        truth.angle = 0.5;
        new ChangingForces(effects).evaluate(truth);
        assertThat(truth.angularAcceleration).isNotZero();
        double lifted = truth.accelerationY;
        double turned = truth.angularAcceleration;
        assertThat(island.bodies.pullY[slot]).isCloseTo(lifted, within(1e-9));
        assertThat(island.bodies.pullTurn[slot]).isCloseTo(isPacked ? turned : 0, within(1e-9));
        assertThat(island.bodies.angularAcceleration[slot])
                .isCloseTo(isPacked ? 9 + turned : 9, within(1e-9));
        double rim = Math.abs(turned) * island.bodies.boundingRadius[slot];
        double most = isPacked ? Math.max(lifted, rim) : lifted;
        assertThat(forces.change()).isCloseTo(most, within(1e-9));
    }

    /** Consecutive kicks evaluate the force again, until it changes. */
    @Test
    void kicksAreSteadyWhileTheForceIs() {
        double[] times = {0, Double.POSITIVE_INFINITY};
        declare(
                at -> {
                    times[0] = Math.max(times[0], at.time);
                    at.push(0, at.time > times[1] ? 2 : 0);
                });
        body(BodyDefinition.dynamic(new Circle(1)));
        Kick kick = new Kick(island.bodies, motions, forces, null, turns);
        assertThat(kick.mayChange()).isTrue();
        assertThat(kick.isSteady(0.1, 0.2, 3, 0.5)).isTrue();
        assertThat(times[0]).isCloseTo(0.5, within(ROUND_OFF));
        assertThat(kick.isForced()).isFalse();
        times[1] = 0.4;
        assertThat(kick.isSteady(0.1, 0.2, 3, 0.5)).isFalse();
        assertThat(kick.isForced()).isTrue();
        kick.refresh(0.1, 0.3);
        assertThat(kick.isForced()).isFalse();
        assertThat(kick.isSteady(0.1, 0.2, 3, 2)).isTrue();
    }
}
