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

    /** One for all blows of a test: none leaves anything to the next. */
    private final ImpactLaw law = new ImpactLaw();

    private Impact resolved(Impact blow) {
        law.resolve(blow);
        return blow;
    }

    /** A box of 1 kg, 2 m high and {@code width} wide along its motion, flat against a wall. */
    private static Impact box(double width, double velocityX, double velocityY, double spin) {
        Impact blow = Meet.wall(velocityX, velocityY, spin, (width * width + 4) / 12);
        blow.addPoint(-width / 2, -1, 0, 0, 0, 0);
        blow.addPoint(-width / 2, 1, 0, 0, 0, 0);
        return blow;
    }

    @Test
    void flatBoxReboundsWithoutTurning() {
        Impact blow = box(2, -4, 0, 0);
        blow.elasticity = 0.25;
        resolved(blow);

        assertThat(blow.velocityBX).isCloseTo(1, within(1e-14));
        assertThat(blow.spinB).isCloseTo(0, within(1e-14));
        assertThat(blow.normalImpulse[0]).isCloseTo(2.5, within(1e-14));
        assertThat(blow.normalImpulse[1]).isCloseTo(2.5, within(1e-14));
        assertThat(blow.slowestParting()).isCloseTo(1, within(1e-14));
    }

    /**
     * The normals are Σjₙ = 4 N·s and keep the box from turning: what friction turns, at half the
     * width, they turn back at 1 m each.
     */
    @ParameterizedTest
    @CsvSource({"1, 9, -0.4", "1, -9, 0.4", "0.5, 9, -0.4", "0.5, 0.25, -0.25", "1, -0.25, 0.25"})
    void flatBoxIsRubbedWithoutTurning(double width, double sliding, double tangent) {
        Impact blow = box(width, -4, sliding, 0);
        blow.friction = 0.1;
        resolved(blow);

        assertThat(blow.tangentImpulse).isCloseTo(tangent, within(1e-14));
        assertThat(blow.spinB).isCloseTo(0, within(1e-14));
        double turned = tangent * -width / 2;
        assertThat(blow.normalImpulse[0]).isCloseTo(2 - turned / 2, within(1e-14));
        assertThat(blow.normalImpulse[1]).isCloseTo(2 + turned / 2, within(1e-14));
    }

    /**
     * Turning at ω = −1, one corner comes at 4 + 1 m/s and the other at 4 − 1. With kₙ = 1 + 1/I
     * and I = ⅔ both push; with e = 1 each leaves at its own speed.
     */
    @Test
    void eachCornerKeepsItsOwnSpeed() {
        Impact blow = box(2, -4, 0, -1);
        blow.elasticity = 1;
        double first = blow.parting(0);
        double second = blow.parting(1);
        resolved(blow);

        assertThat(first).isEqualTo(-5);
        assertThat(second).isEqualTo(-3);
        assertThat(blow.parting(0)).isCloseTo(5, within(1e-13));
        assertThat(blow.parting(1)).isCloseTo(3, within(1e-13));
        assertThat(blow.slowestParting()).isCloseTo(3, within(1e-13));
    }

    /**
     * One corner comes at 3 m/s, the other goes away at 1: it pushes alone, (1 + e)·3/(1 + 1/I).
     */
    @ParameterizedTest
    @ValueSource(ints = {-1, 1})
    void cornerThatPartsDoesNotPush(int sign) {
        Impact blow = box(2, -1, 0, 2 * sign);
        int coming = sign > 0 ? 1 : 0;
        assertThat(blow.parting(coming)).isEqualTo(-3);
        resolved(blow);

        assertThat(blow.normalImpulse[coming]).isCloseTo(3 / 2.5, within(1e-14));
        assertThat(blow.normalImpulse[1 - coming]).isZero();
        assertThat(blow.parting(coming)).isCloseTo(0, within(1e-14));
    }

    /** Where nothing turns both points are one to the arithmetic. */
    @Test
    void bodyThatCannotTurnIsStruckOnce() {
        Impact blow = box(2, -4, 0, 0);
        blow.inverseInertiaB = 0;
        resolved(blow);

        assertThat(blow.points).isEqualTo(1);
        assertThat(blow.velocityBX).isCloseTo(0, within(1e-15));
        assertThat(blow.totalNormalImpulse()).isEqualTo(4);
    }

    /**
     * Two points a micron apart are one, however light what meets there: the one that closes
     * faster, by 10⁻⁶ m/s.
     */
    @ParameterizedTest
    @CsvSource({"-1, 1", "1, 1", "-1, 1e3", "1, 1e3", "-1, 1e-3", "1, 1e-3"})
    void ofTwoPointsInOnePlaceTheFasterCounts(int sign, double inverseMass) {
        Impact blow = box(2, -4, 0, sign);
        blow.inverseMassA = inverseMass;
        blow.inverseMassB = inverseMass;
        blow.inverseInertiaB = 1.5 * inverseMass;
        blow.points = 0;
        blow.addPoint(-1, 0.5, -3, 0.25, 0, 0);
        blow.addPoint(-1 + 1e-9, 0.5 + 1e-6, -3, 0.25, 0, 0);
        int i = sign < 0 ? 0 : 1;
        double[] faster = {blow.armAX[i], blow.armAY[i], blow.armBX[i], blow.armBY[i]};
        assertThat(blow.slowestParting()).isEqualTo(-4 - sign * faster[3]);
        resolved(blow);

        assertThat(blow.points).isEqualTo(1);
        assertThat(new double[] {blow.armAX[0], blow.armAY[0], blow.armBX[0], blow.armBY[0]})
                .containsExactly(faster);
    }

    /** What the law comes to, solved densely case by case; friction up to what jams. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 5})
    void isTheThreeByThreeSolution(double roughness) {
        Random random = new Random(9);
        int[] cases = new int[12];
        for (int i = 0; i < 30_000; i++) {
            Impact blow = Meet.any(random, 2);
            blow.friction *= roughness;
            ThreeByThree truth = new ThreeByThree(blow);
            if (truth.margin > ROUND_OFF) {
                Impact after = resolved(Meet.copy(blow));
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
            Impact blow = Meet.any(random, 2);
            blow.elasticity = 0;
            blow.friction = 0;
            blow.surfaceSpeed = 0;
            int first = random.nextInt(2);
            strikeAway(blow, first);
            assertImpulses(i, resolved(blow), 2 - 2 * first, 2 * first, 0);
        }
    }

    private static void strikeAway(Impact blow, int i) {
        double nx = blow.normalX;
        double ny = blow.normalY;
        blow.velocityAX = 2 * nx * blow.inverseMassA;
        blow.velocityAY = 2 * ny * blow.inverseMassA;
        blow.spinA = 2 * (blow.armAX[i] * ny - blow.armAY[i] * nx) * blow.inverseInertiaA;
        blow.velocityBX = -2 * nx * blow.inverseMassB;
        blow.velocityBY = -2 * ny * blow.inverseMassB;
        blow.spinB = -2 * (blow.armBX[i] * ny - blow.armBY[i] * nx) * blow.inverseInertiaB;
    }

    /**
     * A mast with its weight 10⁵ m up, 1 kg and 1 kg·m², sets both feet down at once and slides:
     * Σjₙ = m·v, friction its share, and the feet share the rest so that nothing turns.
     */
    @ParameterizedTest
    @ValueSource(ints = {-1, 1})
    void aMastSlidesWithoutTurning(int sign) {
        double height = 1e5;
        Impact blow = Meet.wall(-4, sign, 0, 1);
        blow.friction = 1e-6;
        blow.addPoint(-height, -0.5, 0, 0, 0, 0);
        blow.addPoint(-height, 0.5, 0, 0, 0, 0);
        resolved(blow);

        double tangent = -4e-6 * sign;
        assertThat(blow.tangentImpulse).isCloseTo(tangent, within(1e-14));
        assertThat(blow.totalNormalImpulse()).isCloseTo(4, within(1e-9));
        assertThat(blow.normalImpulse[1] - blow.normalImpulse[0])
                .isCloseTo(-2 * height * tangent, within(1e-9));
        assertThat(blow.spinB).isCloseTo(0, within(1e-9));
    }

    /**
     * Bodies so light that the square of what an impulse gives them overflows: no case can be told
     * from another, and of two corners that close the faster is pushed alone, as if it were one.
     */
    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 1})
    void beyondArithmeticTheFasterCornerIsPushed(int sign) {
        Impact blow = box(2, -4, 3, sign);
        blow.elasticity = 0.5;
        blow.inverseMassB = 1e200;
        blow.inverseInertiaB = 1.5e200;
        int faster = sign > 0 ? 1 : 0;
        double speed = 4 + Math.abs(sign);
        assertThat(blow.parting(faster)).isEqualTo(-speed);
        resolved(blow);

        assertThat(blow.parting(faster)).isCloseTo(speed / 2, within(1e-14));
        assertThat(blow.normalImpulse[faster]).isCloseTo(1.5 * speed / 2.5e200, within(1e-214));
        assertThat(blow.normalImpulse[1 - faster]).isZero();
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
            Impact blow = Meet.any(random, 2);
            Impact after = resolved(Meet.copy(blow));
            ImpactLawTest.assertPushed(i, blow, after);
            cases[new Verdict(i, blow, after).kind()]++;
        }
        assertThat(IntStream.of(cases))
                .as("parting, sticking, sliding, scaled back")
                .allMatch(n -> n > 100);
    }

    /** What came of one impact, and whether it is what the law asks. */
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
        private double sliding(Impact blow) {
            double sum = 0;
            for (int i = 0; i < 2; i++) {
                sum +=
                        TwoByTwo.pointY(blow, i) * blow.normalX
                                - TwoByTwo.pointX(blow, i) * blow.normalY;
            }
            return sum / 2 - blow.surfaceSpeed;
        }
    }
}
