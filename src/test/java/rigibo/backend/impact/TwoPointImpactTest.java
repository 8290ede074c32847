package rigibo.backend.impact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Two points of one pair at once: what the law asks of the answer, and boxes by hand. */
class TwoPointImpactTest {

    /** Round-off of three rows whose condition is some hundred at most, m/s at 2 m/s. */
    private static final double ROUND_OFF = 1e-9;

    /** One for all impacts of a test: none leaves anything to the next. */
    private final ImpactLaw law = new ImpactLaw();

    private Impact resolved(Impact impact) {
        law.resolve(impact);
        return impact;
    }

    /** A box of 1 kg, 2 m high and {@code width} wide along its motion, flat against a wall. */
    private static Impact box(double width, double velocityX, double velocityY, double spin) {
        Impact impact = Meet.wall(velocityX, velocityY, spin, (width * width + 4) / 12);
        impact.addPoint(-width / 2, -1, 0, 0, 0, 0);
        impact.addPoint(-width / 2, 1, 0, 0, 0, 0);
        return impact;
    }

    @Test
    void flatBoxReboundsWithoutTurning() {
        Impact impact = box(2, -4, 0, 0);
        impact.elasticity = 0.25;
        resolved(impact);

        assertThat(impact.velocityBX).isCloseTo(1, within(1e-14));
        assertThat(impact.spinB).isCloseTo(0, within(1e-14));
        assertThat(impact.normalImpulse[0]).isCloseTo(2.5, within(1e-14));
        assertThat(impact.normalImpulse[1]).isCloseTo(2.5, within(1e-14));
        assertThat(impact.slowestParting()).isCloseTo(1, within(1e-14));
    }

    /**
     * The normals are Σjₙ = 4 N·s and keep the box from turning: what friction turns, at half the
     * width, they turn back at 1 m each.
     */
    @ParameterizedTest
    @CsvSource({"1, 9, -0.4", "1, -9, 0.4", "0.5, 9, -0.4", "0.5, 0.25, -0.25", "1, -0.25, 0.25"})
    void flatBoxIsRubbedWithoutTurning(double width, double sliding, double tangent) {
        Impact impact = box(width, -4, sliding, 0);
        impact.friction = 0.1;
        resolved(impact);

        assertThat(impact.tangentImpulse).isCloseTo(tangent, within(1e-14));
        assertThat(impact.spinB).isCloseTo(0, within(1e-14));
        double turned = tangent * -width / 2;
        assertThat(impact.normalImpulse[0]).isCloseTo(2 - turned / 2, within(1e-14));
        assertThat(impact.normalImpulse[1]).isCloseTo(2 + turned / 2, within(1e-14));
    }

    /**
     * Turning at ω = −1, one corner comes at 4 + 1 m/s and the other at 4 − 1. With kₙ = 1 + 1/I
     * and I = ⅔ both push; with e = 1 each leaves at its own speed.
     */
    @Test
    void eachCornerKeepsItsOwnSpeed() {
        Impact impact = box(2, -4, 0, -1);
        impact.elasticity = 1;
        double first = impact.parting(0);
        double second = impact.parting(1);
        resolved(impact);

        assertThat(first).isEqualTo(-5);
        assertThat(second).isEqualTo(-3);
        assertThat(impact.parting(0)).isCloseTo(5, within(1e-13));
        assertThat(impact.parting(1)).isCloseTo(3, within(1e-13));
        assertThat(impact.slowestParting()).isCloseTo(3, within(1e-13));
    }

    /**
     * One corner comes at 3 m/s, the other goes away at 1: it pushes alone, (1 + e)·3/(1 + 1/I).
     */
    @ParameterizedTest
    @ValueSource(ints = {-1, 1})
    void cornerThatPartsDoesNotPush(int sign) {
        Impact impact = box(2, -1, 0, 2 * sign);
        int coming = sign > 0 ? 1 : 0;
        assertThat(impact.parting(coming)).isEqualTo(-3);
        resolved(impact);

        assertThat(impact.normalImpulse[coming]).isCloseTo(3 / 2.5, within(1e-14));
        assertThat(impact.normalImpulse[1 - coming]).isZero();
        assertThat(impact.parting(coming)).isCloseTo(0, within(1e-14));
    }

    /** Where nothing turns both points are one to the arithmetic. */
    @Test
    void bodyThatCannotTurnIsStruckOnce() {
        Impact impact = box(2, -4, 0, 0);
        impact.inverseInertiaB = 0;
        resolved(impact);

        assertThat(impact.points).isEqualTo(1);
        assertThat(impact.velocityBX).isCloseTo(0, within(1e-15));
        assertThat(impact.totalNormalImpulse()).isEqualTo(4);
    }

    /**
     * Two points a micron apart are one, however light what meets there: the one that closes
     * faster, by 10⁻⁶ m/s.
     */
    @ParameterizedTest
    @CsvSource({"-1, 1", "1, 1", "-1, 1e3", "1, 1e3", "-1, 1e-3", "1, 1e-3"})
    void ofTwoPointsInOnePlaceTheFasterCounts(int sign, double inverseMass) {
        Impact impact = box(2, -4, 0, sign);
        impact.inverseMassA = inverseMass;
        impact.inverseMassB = inverseMass;
        impact.inverseInertiaB = 1.5 * inverseMass;
        impact.points = 0;
        impact.addPoint(-1, 0.5, -3, 0.25, 0, 0);
        impact.addPoint(-1 + 1e-9, 0.5 + 1e-6, -3, 0.25, 0, 0);
        int i = sign < 0 ? 0 : 1;
        double[] faster = {impact.armAX[i], impact.armAY[i], impact.armBX[i], impact.armBY[i]};
        assertThat(impact.slowestParting()).isEqualTo(-4 - sign * faster[3]);
        resolved(impact);

        assertThat(impact.points).isEqualTo(1);
        assertThat(
                        new double[] {
                            impact.armAX[0], impact.armAY[0], impact.armBX[0], impact.armBY[0]
                        })
                .containsExactly(faster);
    }

    /** The law's result, solved densely case by case, with friction up to jamming. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 5})
    void isTheThreeByThreeSolution(double roughness) {
        Random random = new Random(9);
        int[] cases = new int[12];
        for (int i = 0; i < 30_000; i++) {
            Impact impact = Meet.any(random, 2);
            impact.friction *= roughness;
            ThreeByThree truth = new ThreeByThree(impact);
            if (truth.margin > ROUND_OFF) {
                Impact after = resolved(Meet.copy(impact));
                cases[truth.tried]++;
                assertImpulses(i, after, truth.impulse);
            }
        }
        assertThat(IntStream.of(cases).limit(6))
                .as("with friction: stuck, slid; by the first alone, by the second")
                .allMatch(n -> n > 1000);
        assertThat(IntStream.of(cases).skip(6).sum()).as("without").isPositive();
    }

    private static void assertImpulses(int number, Impact after, double... expected) {
        double[] told = {after.normalImpulse[0], after.normalImpulse[1], after.tangentImpulse};
        double size = 1 + DoubleStream.of(expected).map(Math::abs).sum();
        assertThat(told)
                .as("impact %d, seed 9", number)
                .containsExactly(expected, within(size * ROUND_OFF));
    }

    /**
     * A body that moves as an impulse of −2 N·s at one of its corners would have it is stopped by
     * one of 2 N·s there, and the other corner, which is left with just nothing, pushes not at all.
     */
    @Test
    void oneCornerPushesWhereThatStopsBoth() {
        Random random = new Random(10);
        for (int i = 0; i < 2_000; i++) {
            Impact impact = Meet.any(random, 2);
            impact.elasticity = 0;
            impact.friction = 0;
            impact.surfaceSpeed = 0;
            int first = random.nextInt(2);
            strikeAway(impact, first);
            assertImpulses(i, resolved(impact), 2 - 2 * first, 2 * first, 0);
        }
    }

    private static void strikeAway(Impact impact, int i) {
        double nx = impact.normalX;
        double ny = impact.normalY;
        impact.velocityAX = 2 * nx * impact.inverseMassA;
        impact.velocityAY = 2 * ny * impact.inverseMassA;
        impact.spinA = 2 * (impact.armAX[i] * ny - impact.armAY[i] * nx) * impact.inverseInertiaA;
        impact.velocityBX = -2 * nx * impact.inverseMassB;
        impact.velocityBY = -2 * ny * impact.inverseMassB;
        impact.spinB = -2 * (impact.armBX[i] * ny - impact.armBY[i] * nx) * impact.inverseInertiaB;
    }

    /**
     * A mast with its weight 10⁵ m up, 1 kg and 1 kg·m², sets both feet down at once and slides:
     * Σjₙ = m·v, friction its share, and the feet share the rest so that nothing turns.
     */
    @ParameterizedTest
    @ValueSource(ints = {-1, 1})
    void aMastSlidesWithoutTurning(int sign) {
        double height = 1e5;
        Impact impact = Meet.wall(-4, sign, 0, 1);
        impact.friction = 1e-6;
        impact.addPoint(-height, -0.5, 0, 0, 0, 0);
        impact.addPoint(-height, 0.5, 0, 0, 0, 0);
        resolved(impact);

        double tangent = -4e-6 * sign;
        assertThat(impact.tangentImpulse).isCloseTo(tangent, within(1e-14));
        assertThat(impact.totalNormalImpulse()).isCloseTo(4, within(1e-9));
        assertThat(impact.normalImpulse[1] - impact.normalImpulse[0])
                .isCloseTo(-2 * height * tangent, within(1e-9));
        assertThat(impact.spinB).isCloseTo(0, within(1e-9));
    }

    /**
     * Bodies so light that the square of what an impulse gives them overflows: no case can be told
     * from another, and of two corners that close the faster is pushed alone, as if it were one.
     */
    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 1})
    void beyondArithmeticTheFasterCornerIsPushed(int sign) {
        Impact impact = box(2, -4, 3, sign);
        impact.elasticity = 0.5;
        impact.inverseMassB = 1e200;
        impact.inverseInertiaB = 1.5e200;
        int faster = sign > 0 ? 1 : 0;
        double speed = 4 + Math.abs(sign);
        assertThat(impact.parting(faster)).isEqualTo(-speed);
        resolved(impact);

        assertThat(impact.parting(faster)).isCloseTo(speed / 2, within(1e-14));
        assertThat(impact.normalImpulse[faster]).isCloseTo(1.5 * speed / 2.5e200, within(1e-214));
        assertThat(impact.normalImpulse[1 - faster]).isZero();
    }

    /**
     * What the law asks, checked in world coordinates: nothing pulls, no point is left slower than
     * asked, only what pushes is faster, friction stays in its cone and against the sliding. Where
     * no such answer exists friction is left out; where it would add energy all is scaled back.
     */
    @Test
    void randomImpactsSatisfyTheLaw() {
        Random random = new Random(4);
        int[] cases = new int[4];
        for (int i = 0; i < 20_000; i++) {
            Impact impact = Meet.any(random, 2);
            Impact after = resolved(Meet.copy(impact));
            ImpactLawTest.assertPushed(i, impact, after);
            cases[new Verdict(i, impact, after).kind()]++;
        }
        assertThat(IntStream.of(cases))
                .as("parting, sticking, sliding, scaled back")
                .allMatch(n -> n > 100);
    }

    /** The result of an impact, and whether the law allows it. */
    private record Verdict(int number, Impact before, Impact after) {

        /** 0: nothing closed; 1: stuck; 2: slid; 3: scaled back. */
        int kind() {
            if (before.slowestParting() >= 0) {
                assertThat(after.totalNormalImpulse())
                        .as(this::words)
                        .isCloseTo(0, within(ROUND_OFF));
                return 0;
            }
            if (isScaledBack()) {
                return 3;
            }
            assertNormals();
            return assertFriction();
        }

        private String words() {
            return "impact %d, seed 4".formatted(number);
        }

        /** Then just the energy that the belt does not put in is kept, and friction in its cone. */
        private boolean isScaledBack() {
            boolean keepsEnergy = Math.abs(work()) < ROUND_OFF;
            boolean lags = false;
            for (int i = 0; i < 2; i++) {
                lags |= after.parting(i) < target(i) - ROUND_OFF;
            }
            if (lags) {
                assertThat(keepsEnergy).as(this::words).isTrue();
            }
            return lags;
        }

        /** By the impulses on the point, at the mean of the velocities before and after. */
        private double work() {
            double normal = 0;
            for (int i = 0; i < 2; i++) {
                normal += after.normalImpulse[i] * (before.parting(i) + after.parting(i)) / 2;
            }
            return normal + after.tangentImpulse * (sliding(before) + sliding(after)) / 2;
        }

        private void assertNormals() {
            for (int i = 0; i < 2; i++) {
                double push = after.normalImpulse[i];
                assertThat(push).as(this::words).isGreaterThanOrEqualTo(0);
                double over = after.parting(i) - target(i);
                assertThat(Math.min(push, over)).as(this::words).isCloseTo(0, within(ROUND_OFF));
            }
        }

        private int assertFriction() {
            double most = before.friction * after.totalNormalImpulse();
            double tangent = after.tangentImpulse;
            double sliding = sliding(after);
            assertThat(Math.abs(tangent)).as(this::words).isLessThanOrEqualTo(most + ROUND_OFF);
            assertThat(tangent * sliding).as(this::words).isLessThanOrEqualTo(ROUND_OFF);
            if (Math.abs(sliding) < ROUND_OFF) {
                return 1;
            }
            assertThat(Math.abs(tangent))
                    .as(this::words)
                    .satisfiesAnyOf(
                            all -> assertThat(all).isCloseTo(most, within(ROUND_OFF)),
                            none -> assertThat(none).isZero());
            return 2;
        }

        private double target(int i) {
            return Math.max(0, -before.elasticity * before.parting(i));
        }

        /** Of the middle of the points against the belt, m/s along (−ny, nx). */
        private double sliding(Impact impact) {
            double sum = 0;
            for (int i = 0; i < 2; i++) {
                sum +=
                        TwoByTwo.pointY(impact, i) * impact.normalX
                                - TwoByTwo.pointX(impact, i) * impact.normalY;
            }
            return sum / 2 - impact.surfaceSpeed;
        }
    }
}
