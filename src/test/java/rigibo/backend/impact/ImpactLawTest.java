package rigibo.backend.impact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;
import java.util.stream.IntStream;

/** One point: Newton's law and Coulomb's against their 2 × 2 solution, and cases by hand. */
class ImpactLawTest {

    /** A few roundings of sums of terms of that size, multiplied by the condition of the 2 × 2. */
    private static final double ROUND_OFF = 1e-10;

    /** One for all impacts of a test: none leaves anything to the next. */
    private final ImpactLaw law = new ImpactLaw();

    private Impact resolved(Impact impact) {
        law.resolve(impact);
        return impact;
    }

    @Test
    void isTheTwoByTwoSolution() {
        Random random = new Random(1);
        int[] cases = new int[3];
        for (int i = 0; i < 100_000; i++) {
            Impact impact = Meet.any(random, 1);
            if (impact.parting(0) < 0) {
                TwoByTwo truth = new TwoByTwo(impact);
                cases[truth.isScaled ? 0 : truth.sticks ? 1 : 2]++;
                assertOutcome(i, impact, truth);
            }
        }
        assertThat(IntStream.of(cases)).as("scaled back, sticking, sliding").allMatch(n -> n > 100);
    }

    private void assertOutcome(int number, Impact impact, TwoByTwo truth) {
        Impact after = resolved(Meet.copy(impact));
        double scale = Math.abs(truth.x) + Math.abs(truth.y) + 1;
        double jx = after.normalImpulse[0] * impact.normalX - after.tangentImpulse * impact.normalY;
        double jy = after.normalImpulse[0] * impact.normalY + after.tangentImpulse * impact.normalX;
        assertThat(jx)
                .as("impact %d, seed 1", number)
                .isCloseTo(truth.x, within(scale * ROUND_OFF));
        assertThat(jy)
                .as("impact %d, seed 1", number)
                .isCloseTo(truth.y, within(scale * ROUND_OFF));
        assertPushed(number, impact, after);
    }

    /**
     * Both bodies get the impulse that is told, at the point where they meet, against each other.
     */
    static void assertPushed(int number, Impact before, Impact after) {
        double nx = before.normalX;
        double ny = before.normalY;
        double jx = -after.tangentImpulse * ny;
        double jy = after.tangentImpulse * nx;
        double momentA = 0;
        double momentB = 0;
        int last = after.points - 1;
        for (int i = 0; i <= last; i++) {
            double share = 1.0 / after.points;
            double px = after.normalImpulse[i] * nx - share * after.tangentImpulse * ny;
            double py = after.normalImpulse[i] * ny + share * after.tangentImpulse * nx;
            jx += after.normalImpulse[i] * nx;
            jy += after.normalImpulse[i] * ny;
            momentA += after.armAX[i] * py - after.armAY[i] * px;
            momentB += after.armBX[i] * py - after.armBY[i] * px;
        }
        double off =
                Math.abs(after.velocityAX - before.velocityAX + before.inverseMassA * jx)
                        + Math.abs(after.velocityAY - before.velocityAY + before.inverseMassA * jy)
                        + Math.abs(after.spinA - before.spinA + before.inverseInertiaA * momentA)
                        + Math.abs(after.velocityBX - before.velocityBX - before.inverseMassB * jx)
                        + Math.abs(after.velocityBY - before.velocityBY - before.inverseMassB * jy)
                        + Math.abs(after.spinB - before.spinB - before.inverseInertiaB * momentB);
        double scale = 1 + Math.abs(jx) + Math.abs(jy);
        assertThat(off).as("impact %d", number).isLessThan(scale * ROUND_OFF);
    }

    /** However it rubs: sticking would hold a point whose friction presses it on. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void holdsNothingThatParts(int points) {
        Random random = new Random(2);
        for (int i = 0; i < 20_000; i++) {
            Impact impact = Meet.any(random, points);
            if (impact.slowestParting() >= 0) {
                Impact after = resolved(Meet.copy(impact));
                assertThat(after.totalNormalImpulse()).as("impact %d, seed 2", i).isZero();
                assertThat(after.tangentImpulse).isZero();
                assertThat(energy(after)).isEqualTo(energy(impact));
            }
        }
    }

    /**
     * Bodies that slide along each other, neither closing nor parting, and rub as hard as they may:
     * there is no impact that friction could be a share of.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void whatOnlySlidesIsNotStruck(int points) {
        Random random = new Random(7);
        for (int i = 0; i < 2_000; i++) {
            Impact impact = Meet.stopped(Meet.level(random, points));
            impact.velocityBY = Meet.between(random, -2, 2);
            impact.friction = Meet.between(random, 0, 8);
            Impact after = resolved(Meet.copy(impact));
            assertThat(after.totalNormalImpulse()).as("impact %d, seed 7", i).isZero();
            assertThat(after.tangentImpulse).as("impact %d, seed 7", i).isZero();
            assertThat(energy(after)).isEqualTo(energy(impact));
        }
    }

    /**
     * An impact out of all bounds leaves nothing in the carrier or the law that the next one would
     * use.
     */
    @Test
    void anUnboundedImpactLeavesNothingBehind() {
        Random random = new Random(8);
        for (int i = 0; i < 1_000; i++) {
            Impact wild = Meet.any(random, 2);
            wild.armAX[1] = Double.POSITIVE_INFINITY;
            wild.armBY[1] = Double.NaN;
            resolved(wild);
            Impact impact = Meet.any(random, 1);
            Impact after = resolved(Meet.copy(impact));
            if (impact.parting(0) < 0) {
                assertOutcome(i, impact, new TwoByTwo(impact));
            } else {
                assertThat(energy(after)).isEqualTo(energy(impact));
            }
        }
    }

    /** A point that goes away at 1 m/s by the spin of a body that comes at 1 m/s. */
    @Test
    void onlyPointsThatTouchCount() {
        Impact impact = Meet.wall(-1, 0, 2, 0.5);
        impact.addPoint(-1, -1, 0, 0, 0, 0);
        impact.addPoint(-1, 1, 0, 0, 0, 0);
        assertThat(impact.slowestParting()).isEqualTo(-3);
        assertThat(resolved(impact).totalNormalImpulse())
                .isEqualTo(impact.normalImpulse[1])
                .isPositive();

        Impact other = Meet.wall(-1, 0, 2, 0.5);
        other.addPoint(-1, -1, 0, 0, 0, 0);
        assertThat(other.slowestParting()).isEqualTo(1);
        other.normalImpulse[1] = 7;
        assertThat(resolved(other).totalNormalImpulse()).isZero();
    }

    /**
     * With half of the speed e, 1 kg that comes at 2 m/s leaves at 1 m/s by an impulse of 3 N·s.
     */
    @Test
    void reboundsFromAWallByItsElasticity() {
        Impact impact = Meet.wall(-2, 0, 0, 0.5);
        impact.addPoint(-1, 0, 0, 0, 0, 0);
        impact.elasticity = 0.5;
        resolved(impact);

        assertThat(impact.velocityBX).isEqualTo(1);
        assertThat(impact.totalNormalImpulse()).isEqualTo(3);
        assertThat(impact.slowestParting()).isEqualTo(1);
    }

    @Test
    void anotherElasticityStandsInForItsOwn() {
        Impact impact = Meet.wall(-2, 0, 0, 0.5);
        impact.addPoint(-1, 0, 0, 0, 0, 0);
        impact.elasticity = 0.5;
        new ImpactLaw().resolve(impact, 0);

        assertThat(impact.velocityBX).isZero();
        assertThat(impact.totalNormalImpulse()).isEqualTo(2);
    }

    /**
     * A disc of 1 kg, radius 1 m and inertia ½ kg·m² that sticks: kₜ = 1 + 1/½ = 3, jₜ = −vₜ/3. It
     * comes off with the two thirds of its speed at which it then rolls.
     */
    @ParameterizedTest
    @ValueSource(doubles = {-1.5, 1.5})
    void stickingDiscLeavesRolling(double sliding) {
        Impact impact = Meet.wall(-2, sliding, 0, 0.5);
        impact.addPoint(-1, 0, 0, 0, 0, 0);
        impact.friction = 1;
        resolved(impact);

        assertThat(impact.tangentImpulse).isCloseTo(-sliding / 3, within(1e-15));
        assertThat(impact.velocityBY).isCloseTo(sliding * 2 / 3, within(1e-15));
        assertThat(impact.velocityBY - impact.spinB).as("rolls").isCloseTo(0, within(1e-15));
    }

    /** It needs |jₜ| = ½ of the normal 2 N·s and gets 0.1 of it. */
    @ParameterizedTest
    @ValueSource(doubles = {-3, 3})
    void slidingDiscIsRubbedByCoulombsShare(double sliding) {
        Impact impact = Meet.wall(-2, sliding, 0, 0.5);
        impact.addPoint(-1, 0, 0, 0, 0, 0);
        impact.friction = 0.1;
        resolved(impact);

        assertThat(impact.velocityBX).isCloseTo(0, within(1e-15));
        assertThat(impact.tangentImpulse).isCloseTo(-Math.copySign(0.2, sliding), within(1e-15));
    }

    /** Rubbing starts from the speed of the belt, not from rest: jₜ = (1.5 − 0)/3. */
    @Test
    void sticksToARunningSurface() {
        Impact impact = Meet.wall(-2, 0, 0, 0.5);
        impact.addPoint(-1, 0, 0, 0, 0, 0);
        impact.friction = 1;
        impact.surfaceSpeed = 1.5;
        resolved(impact);

        assertThat(impact.tangentImpulse).isCloseTo(0.5, within(1e-15));
        assertThat(impact.velocityBY - impact.spinB).isCloseTo(1.5, within(1e-15));
    }

    /**
     * An end of a rod at (−0.4, −0.3) from its centre, with 1/I = 12: kₙ = 1 + 12·0.3² = 2.08 and
     * kₙₜ = −12·0.4·0.3 = −1.44. Sliding down, friction turns the end into the wall, and less
     * impulse does; sliding up it turns it away: jₙ = 3/(kₙ − μ·sgn(vₜ)·kₙₜ).
     */
    @ParameterizedTest
    @CsvSource({"-9, 1.36", "9, 2.80"})
    void frictionLiftsOrPressesTheEndOfARod(double sliding, double response) {
        Impact impact = Meet.wall(-2, sliding, 0, 1.0 / 12);
        impact.addPoint(-0.4, -0.3, 0, 0, 0, 0);
        impact.friction = 0.5;
        impact.elasticity = 0.5;
        resolved(impact);

        assertThat(impact.totalNormalImpulse()).isCloseTo(3 / response, within(1e-14));
        assertThat(impact.parting(0)).isCloseTo(1, within(1e-14));
    }

    @Test
    void noImpactAddsEnergy() {
        Random random = new Random(3);
        for (int points = 1; points <= 2; points++) {
            for (int i = 0; i < 20_000; i++) {
                Impact impact = Meet.any(random, points);
                impact.surfaceSpeed = 0;
                Meet.haltFixed(impact);
                double before = energy(impact);
                assertThat(energy(resolved(impact)))
                        .as("impact %d of %d points, seed 3", i, points)
                        .isLessThanOrEqualTo(before * (1 + 1e-12));
            }
        }
    }

    static double energy(Impact impact) {
        return half(impact.inverseMassA, impact.velocityAX, impact.velocityAY)
                + half(impact.inverseInertiaA, impact.spinA, 0)
                + half(impact.inverseMassB, impact.velocityBX, impact.velocityBY)
                + half(impact.inverseInertiaB, impact.spinB, 0);
    }

    /** ½mv², 0 for what is fixed. */
    private static double half(double inverse, double x, double y) {
        return inverse == 0 ? 0 : (x * x + y * y) / inverse / 2;
    }
}
