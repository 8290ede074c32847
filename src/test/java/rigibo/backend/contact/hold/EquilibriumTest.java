package rigibo.backend.contact.hold;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.Recovery;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Correction;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.KeptOverlap;
import rigibo.backend.storage.Pairs;

/**
 * A box of 2 kg, 1 m wide, stands with both corners on a floor under 10 m/s²: each corner carries
 * 10 N. Its loads add up to 20 m/s², half by its weight and half by its support.
 */
class EquilibriumTest {

    private static final int FLOOR = 0;
    private static final int BOX = 1;
    private static final double DT = 1.0 / 60;
    private static final double MASS = 2;
    private static final double PULL = 10;
    private static final double OWN = 20;
    private static final double INVERSE_INERTIA = 3;
    private static final double RADIUS = 0.8;

    private final DataStorage data =
            new DataStorage(
                    Effects.of(
                            new Contacts(),
                            new Rotation(),
                            new Friction(),
                            new RollingResistance(),
                            new SurfaceSpeed()));
    private final Bodies bodies = data.bodies;
    private final Pairs pairs = data.pairs;

    @BeforeEach
    void lay() {
        bodies.type[FLOOR] = BodyType.STATIC;
        bodies.smallestWidth[FLOOR] = 5;
        bodies.type[BOX] = BodyType.DYNAMIC;
        bodies.y[BOX] = 0.5;
        bodies.inverseMass[BOX] = 1 / MASS;
        bodies.inverseInertia[BOX] = INVERSE_INERTIA;
        bodies.boundingRadius[BOX] = RADIUS;
        bodies.smallestWidth[BOX] = 1;
        bodies.accelerationY[BOX] = -PULL;
        pairs.bodyA[0] = FLOOR;
        pairs.bodyB[0] = BOX;
        pairs.normalY[0] = 1;
        pairs.points[0] = 2;
        pairs.pointX[0] = -0.5;
        pairs.pointX[1] = 0.5;
        load(10, 10);
        data.islands.count = 1;
        data.islands.bodies[0] = BOX;
        data.islands.bodyStart[1] = 1;
        data.islands.pairStart[1] = 1;
    }

    private void load(double left, double right) {
        pairs.normalForce[0] = left;
        pairs.normalForce[1] = right;
    }

    private boolean lasts() {
        return new Equilibrium(data, Accuracy.GAME).lasts(0, DT);
    }

    private boolean isOverlapping(Accuracy accuracy) {
        Equilibrium test = new Equilibrium(data, accuracy);
        assertThat(test.lasts(0, DT)).isTrue();
        return test.isOverlapping();
    }

    /** The residual may be 10⁻⁹ of all loads, 2·10⁻⁸ m/s², in either direction. */
    @ParameterizedTest
    @CsvSource({"0, true", "0.99, true", "-0.99, true", "1.01, false", "-1.01, false"})
    void forcesBalance(double times, boolean isHeld) {
        double missing = times * Equilibrium.UNHELD * OWN * MASS;
        load(10 + missing / 2, 10 + missing / 2);
        assertThat(lasts()).isEqualTo(isHeld);
    }

    /**
     * Moving a force from one corner to the other turns the box by its lever of 1 m: r·α counts.
     */
    @ParameterizedTest
    @CsvSource({"0.99, true", "-0.99, true", "1.01, false", "-1.01, false"})
    void torquesBalance(double times, boolean isHeld) {
        double moved = times * Equilibrium.UNHELD * OWN / (RADIUS * INVERSE_INERTIA);
        load(10 - moved, 10 + moved);
        assertThat(lasts()).isEqualTo(isHeld);
    }

    /** A beam on two supports: N₀ = W·b/(a + b), N₁ = W·a/(a + b). */
    @Test
    void loadsFollowTheLevers() {
        pairs.pointX[0] = -0.3;
        load(12.5, 7.5);
        assertThat(lasts()).isTrue();
        load(7.5, 12.5);
        assertThat(lasts()).isFalse();
        bodies.x[BOX] = 0.2;
        assertThat(lasts()).isTrue();
    }

    /** The box stands at a wall to its right; A and B are exchanged. */
    @Test
    void firstBodyIsPushedTheOtherWay() {
        pairs.bodyA[0] = BOX;
        pairs.bodyB[0] = FLOOR;
        pairs.normalY[0] = -1;
        assertThat(lasts()).isTrue();
        pairs.normalY[0] = 1;
        assertThat(lasts()).isFalse();
    }

    /**
     * Pulled to the right by 3 m/s², the box is held by a friction of 6 N at its foot, which turns
     * it by 3 N·m. So the right corner carries 3 N more, the left one 3 N less. All forces are
     * within the cone if μ·20 N is at least 6 N.
     */
    @ParameterizedTest
    @CsvSource({"0.31, true", "0.3, true", "0.299999, false", "0, false"})
    void frictionHoldsWithinItsCone(double friction, boolean isHeld) {
        bodies.accelerationX[BOX] = 3;
        pairs.friction[0] = friction;
        // The tangent points to the left.
        pairs.frictionForce[0] = 6;
        load(7, 13);
        assertThat(lasts()).isEqualTo(isHeld);
        bodies.accelerationX[BOX] = -3;
        pairs.frictionForce[0] = -6;
        load(13, 7);
        assertThat(lasts()).isEqualTo(isHeld);
    }

    /** Friction acts at the height of the nearer point, 0.2 m up, so its lever is 0.3 m. */
    @Test
    void frictionActsAtTheNearerPoint() {
        bodies.accelerationX[BOX] = 3;
        pairs.friction[0] = 1;
        pairs.frictionForce[0] = 6;
        pairs.pointY[1] = 0.2;
        pairs.separation[0] = 1e-6;
        load(8.2, 11.8);
        assertThat(lasts()).isTrue();
        pairs.separation[1] = 2e-6;
        assertThat(lasts()).isFalse();
    }

    /** A torque of 2 N·m is the lever of 1 m of a force of 2 N; the bound is c·N = 20·c N·m. */
    @ParameterizedTest
    @CsvSource({"0.11, 2, true", "0.1, 2, true", "0.0999, 2, false", "0.1, -2, true"})
    void rollingResistanceHoldsWithinItsBound(double lever, double torque, boolean isHeld) {
        bodies.rollingResistance[FLOOR] = lever / 2;
        bodies.rollingResistance[BOX] = lever;
        pairs.rollingTorque[0] = torque;
        load(10 + torque, 10 - torque);
        assertThat(lasts()).isEqualTo(isHeld);
        load(10 - torque, 10 + torque);
        assertThat(lasts()).isFalse();
    }

    /** Any point of the body may move by 10⁻⁹ widths in a step. */
    @ParameterizedTest
    @CsvSource({
        "0.9, 0, 0, true",
        "0, -0.9, 0, true",
        "0, 0, 0.9, true",
        "1.1, 0, 0, false",
        "0, -1.1, 0, false",
        "0, 0, -1.1, false",
        "0.4, -0.4, 0.4, false"
    })
    void whatMovesIsSolved(double x, double y, double turn, boolean isHeld) {
        double most = Stillness.STILL / DT;
        bodies.velocityX[BOX] = x * most;
        bodies.velocityY[BOX] = y * most;
        bodies.spin[BOX] = turn * most / RADIUS;
        assertThat(lasts()).isEqualTo(isHeld);
        bodies.smallestWidth[BOX] = 2;
        assertThat(lasts()).isTrue();
    }

    @Test
    void whatJoinedWithinTheStepIsSolved() {
        bodies.pileTime[BOX] = DT / 2;
        assertThat(lasts()).isFalse();
    }

    @Test
    void whatLiesOnSomethingDrivenIsSolved() {
        bodies.type[FLOOR] = BodyType.KINEMATIC;
        assertThat(lasts()).isTrue();
        bodies.velocityX[FLOOR] = 1;
        assertThat(lasts()).isFalse();
        bodies.velocityX[FLOOR] = 0;
        bodies.surfaceSpeed[FLOOR] = 1;
        assertThat(lasts()).isFalse();
    }

    /** A gap up to a thousandth of the width of the moving body, not of the floor's. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void pointsThatCarryAreClosed(int point) {
        pairs.separation[point] = 0.99e-3;
        assertThat(lasts()).isTrue();
        pairs.separation[point] = 1.01e-3;
        assertThat(lasts()).isFalse();
        pairs.normalForce[point] = 0;
        pairs.normalForce[1 - point] = 20;
        pairs.pointX[1 - point] = 0;
        assertThat(lasts()).isTrue();
    }

    /** The overlap to remove in a step counts from 10⁻⁹ widths on. */
    @Test
    void overlapIsToldFromWhatIsKept() {
        double kept = KeptOverlap.LEAST + Recovery.overlapOf(Stillness.STILL, DT);
        pairs.separation[0] = -0.9999 * kept;
        assertThat(isOverlapping(Accuracy.GAME)).isFalse();
        pairs.separation[1] = -1.0001 * kept;
        assertThat(isOverlapping(Accuracy.GAME)).isTrue();
        assertThat(isOverlapping(Accuracy.GAME.withCorrection(Correction.NONE))).isFalse();
        // An ulp is 1.9e-9 m there, and four of them count as none.
        bodies.x[BOX] = 1e7;
        pairs.pointX[0] += 1e7;
        pairs.pointX[1] += 1e7;
        assertThat(isOverlapping(Accuracy.GAME)).isFalse();
    }

    /** For joined bodies the forces of joints are added, and the body may move as loads yield. */
    @Test
    void jointsCarryWhatContactsDoNot() {
        load(0, 0);
        Equilibrium test = new Equilibrium(data, Accuracy.GAME);
        assertThat(test.mayLast(0, DT)).isTrue();
        assertThat(test.isHeld(0, DT, DT)).isFalse();
        test.add(BOX, 0, MASS * PULL, 0);
        assertThat(test.isHeld(0, DT, DT)).isTrue();
        test.add(BOX, 0, 0, 1e-6);
        assertThat(test.isHeld(0, DT, DT)).isFalse();
        test.add(BOX, 1e-6, 0, -1e-6);
        assertThat(test.isHeld(0, DT, DT)).isFalse();
    }

    /** 10⁻⁸ of 20 m/s² in a kick of 1 s is 2·10⁻⁷ m/s; longer kicks yield by more. */
    @ParameterizedTest
    @CsvSource({"1.9e-7, 1, true", "2.1e-7, 1, false", "2.1e-7, 2, true"})
    void joinedBodiesGiveWay(double speed, double kicked, boolean isHeld) {
        bodies.velocityX[BOX] = speed;
        Equilibrium test = new Equilibrium(data, Accuracy.GAME);
        assertThat(test.mayLast(0, DT)).isTrue();
        assertThat(test.isHeld(0, DT, kicked)).isEqualTo(isHeld);
    }

    /** 10⁻⁶ widths in a step, and no overlap left to remove. */
    @Test
    void joinedBodiesThatMoveAreSolved() {
        Equilibrium test = new Equilibrium(data, Accuracy.GAME);
        bodies.velocityX[BOX] = 0.9e-6 / DT;
        assertThat(test.mayLast(0, DT)).isTrue();
        bodies.velocityX[BOX] = 1.1e-6 / DT;
        assertThat(test.mayLast(0, DT)).isFalse();
        bodies.velocityX[BOX] = 0;
        pairs.separation[0] = -2 * KeptOverlap.LEAST;
        assertThat(test.mayLast(0, DT)).isFalse();
    }
}
