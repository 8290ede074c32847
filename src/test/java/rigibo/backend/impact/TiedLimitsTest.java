package rigibo.backend.impact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Bodies;

import java.util.Random;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Ties against single impacts, whose law is tested by itself, and what holds ties in bounds. */
class TiedLimitsTest {

    /** Round-off of impulses that grew in each of 300 passes. */
    private static final double ROUND_OFF = 1e-9;

    private final FilledStorage storage =
            new FilledStorage(new Contacts(), new Rotation(), new Friction());
    private final Bodies bodies = storage.bodies;
    private TiedImpacts tied;

    @BeforeEach
    void begin() {
        tied = new TiedImpacts(bodies, storage.pairs);
    }

    private int add(double velocityX) {
        return storage.add(BodyDefinition.dynamic(new Circle(1)).mass(1).velocity(velocityX, 0));
    }

    private int drive(double velocityX) {
        return storage.add(BodyDefinition.kinematic(new Circle(1)).velocity(velocityX, 0));
    }

    /** Frictionless, from A to B along x. */
    private int tie(int a, int b, double elasticity) {
        int pair = storage.pair(a, b);
        storage.pairs.normalX[pair] = 1;
        storage.pairs.normalY[pair] = 0;
        Impact impact = new Impact();
        impact.load(bodies, storage.pairs, pair);
        impact.friction = 0;
        impact.addPoint(1, 0, 0, 0, 2, 0);
        tied.add(pair, impact, elasticity);
        return pair;
    }

    /** Writes an impact's bodies into the columns; a tie of it alone then has the law's answer. */
    private void write(Impact impact) {
        bodies.inverseMass[0] = impact.inverseMassA;
        bodies.inverseMass[1] = impact.inverseMassB;
        bodies.inverseInertia[0] = impact.inverseInertiaA;
        bodies.inverseInertia[1] = impact.inverseInertiaB;
        bodies.velocityX[0] = impact.velocityAX;
        bodies.velocityY[0] = impact.velocityAY;
        bodies.spin[0] = impact.spinA;
        bodies.velocityX[1] = impact.velocityBX;
        bodies.velocityY[1] = impact.velocityBY;
        bodies.spin[1] = impact.spinB;
    }

    private double off(Impact after) {
        return Math.abs(bodies.velocityX[0] - after.velocityAX)
                + Math.abs(bodies.velocityY[0] - after.velocityAY)
                + Math.abs(bodies.spin[0] - after.spinA)
                + Math.abs(bodies.velocityX[1] - after.velocityBX)
                + Math.abs(bodies.velocityY[1] - after.velocityBY)
                + Math.abs(bodies.spin[1] - after.spinB);
    }

    /** Sticking, sliding or scaled back by the energy, over a running surface or not. */
    @Test
    void aTieOfOneIsTheImpactAlone() {
        assertThat(answeredAsAlone(5_000, 5, TiedLimitsTest::closing)).isGreaterThan(4000);
    }

    /** Without friction two points have one answer. */
    @Test
    void aTieOfTwoPointsIsTheImpactAlone() {
        assertThat(answeredAsAlone(3_000, 6, TiedLimitsTest::smoothOnTwoPoints))
                .isGreaterThan(2500);
    }

    private static Impact closing(Random random) {
        Impact impact = Meet.any(random, 1);
        return impact.parting(0) < 0 ? impact : closing(random);
    }

    private static Impact smoothOnTwoPoints(Random random) {
        Impact impact = Meet.any(random, 2);
        impact.friction = 0;
        return impact;
    }

    /** Velocities and the impulse told for the pair, which is also what was scaled back. */
    private int answeredAsAlone(int count, long seed, Function<Random, Impact> draw) {
        add(0);
        add(0);
        int pair = storage.pair(0, 1);
        Random random = new Random(seed);
        int answered = 0;
        for (int i = 0; i < count; i++) {
            Impact impact = draw.apply(random);
            write(impact);
            tied.clear();
            tied.add(pair, impact, impact.elasticity);
            storage.pairs.impulse[pair] = 0;
            if (tied.resolve()) {
                answered++;
                new ImpactLaw().resolve(impact);
                // Ten passes to a digit, where rows hang together most.
                assertThat(off(impact)).as("impact %d, seed %d", i, seed).isLessThan(1e-8);
                double told = storage.pairs.impulse[pair];
                assertThat(told).isCloseTo(impact.totalNormalImpulse(), within(1e-8 * (1 + told)));
            }
        }
        return answered;
    }

    /**
     * Two discs that close at 2u are struck together by two that are driven, at v and e = 1:
     * nothing can part them. The impulses are scaled by one share, so that no row is left faster
     * than twice the fastest before; its own speed and what is added to it come to that in the one
     * that is nearest. What is told is what moves the discs.
     */
    @ParameterizedTest
    @CsvSource({"1, 0", "0.1, 0", "1, 0.25", "1, 0.5", "3, -0.5"})
    void impactsWithoutAnAnswerLeaveNoRowTwiceAsFast(double driven, double own) {
        beginAfterAFasterInstant();
        int left = add(own);
        int right = add(-own);
        int behind = drive(driven);
        int ahead = drive(-driven);
        int[] pairs = {tie(left, right, 1), tie(behind, left, 1), tie(right, ahead, 1)};
        assertThat(tied.resolve()).isFalse();

        double[] rows = {-2 * own, own - driven, own - driven};
        double most = DoubleStream.of(rows).map(Math::abs).max().getAsDouble();
        double x = bodies.velocityX[left];
        double y = bodies.velocityX[right];
        double[] rowsAfter = {y - x, x - driven, -driven - y};
        double farthest = 0;
        for (int i = 0; i < 3; i++) {
            assertThat(Math.abs(rowsAfter[i])).isLessThanOrEqualTo(2 * most * (1 + ROUND_OFF));
            double gone = Math.abs(rowsAfter[i] - rows[i]) + Math.abs(rows[i]);
            farthest = Math.max(farthest, gone);
        }
        assertThat(farthest).isCloseTo(2 * most, within(2 * most * ROUND_OFF));
        double[] told =
                IntStream.of(pairs).mapToDouble(pair -> storage.pairs.impulse[pair]).toArray();
        assertThat(bodies.velocityX[left]).isCloseTo(own + told[1] - told[0], within(1e-9));
        assertThat(bodies.velocityX[right]).isCloseTo(told[0] - own - told[2], within(1e-9));
    }

    /** Leaves rows of it behind, faster than any that come. */
    private void beginAfterAFasterInstant() {
        for (int i = 0; i < 10; i++) {
            int first = add(1000);
            tie(first, add(0), 1);
        }
        assertThat(tied.resolve()).isTrue();
        assertThat(storage.pairs.impulse).startsWith(new double[] {1000}, within(1e-9));
        tied.clear();
    }

    /** One impact is answered by the first pass, and asked again by none. */
    @ParameterizedTest
    @ValueSource(doubles = {3, 0, -3})
    void loneImpactTakesTheWorkOfItsRow(double velocity) {
        beginAfterAFasterInstant();
        int first = add(velocity);
        int pair = tie(first, add(0), 0);
        assertThat(tied.resolve()).isTrue();

        assertThat(tied.work()).isEqualTo(TiedImpacts.WORK_OF_ROW);
        assertThat(storage.pairs.impulse[pair]).isEqualTo(Math.max(0, velocity / 2));
        assertThat(storage.pairs.impulse[0]).as("told once").isCloseTo(1000, within(1e-9));
    }

    /** A row for each point, and one for what rubs; none for an impact that touches nowhere. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0, 0.5, 0", "1, 0, 1", "1, 0.5, 2", "2, 0, 2", "2, 0.5, 3"})
    void everyPointHasItsRow(int points, double friction, int rows) {
        add(0);
        add(0);
        Impact impact = Meet.any(new Random(11), 2);
        impact.points = points;
        impact.friction = friction;
        tied.add(storage.pair(0, 1), impact, 0);
        // At rest nothing closes: one pass asks every row once.
        assertThat(tied.resolve()).isTrue();
        assertThat(tied.work()).isEqualTo(TiedImpacts.WORK_OF_ROW * rows);
    }

    /**
     * A row of three, plastic, however slow or heavy: they go on together at a third of the speed,
     * by impulses of two thirds and one third, to the same relative precision.
     */
    @ParameterizedTest
    @CsvSource({"1e-8, 1", "1e-8, 1e-6", "1e-8, 1e6", "10, 1e6", "10, 1e-6"})
    void precisionIsRelative(double speed, double mass) {
        beginAfterAFasterInstant();
        int[] slots = new int[3];
        for (int i = 0; i < 3; i++) {
            BodyDefinition disc = BodyDefinition.dynamic(new Circle(1)).mass(mass);
            slots[i] = storage.add(disc.velocity(i == 0 ? speed : 0, 0));
        }
        int[] pairs = {tie(slots[0], slots[1], 0), tie(slots[1], slots[2], 0)};
        assertThat(tied.resolve()).isTrue();

        for (int i = 0; i < 3; i++) {
            assertThat(bodies.velocityX[slots[i]]).isCloseTo(speed / 3, within(1e-13 * speed));
        }
        for (int i = 0; i < 2; i++) {
            assertThat(storage.pairs.impulse[pairs[i]] / mass / speed)
                    .isCloseTo((2 - i) / 3.0, within(1e-12));
        }
    }

    /** 10²⁰⁰ kg at 10²⁰⁰ m/s: the wall that is struck by 0·∞ stays where it is. */
    @Test
    void unboundedImpulsesMoveNoWall() {
        int disc = add(0);
        int wall = storage.add(BodyDefinition.fixed(new Circle(1)));
        int driven = drive(3);
        bodies.inverseMass[disc] = 1e-200;
        bodies.velocityX[disc] = 1e200;
        tie(disc, wall, 0);
        tie(driven, disc, 0);
        tied.resolve();

        assertThat(bodies.velocityX[wall]).isZero();
        assertThat(bodies.velocityX[driven]).isEqualTo(3);
        assertThat(bodies.spin[wall]).isZero();
    }

    /** More rows than there was room for, each of an impact of its own: equal discs exchange. */
    @Test
    void holdsAsManyImpactsAsFallOnTheInstant() {
        for (int i = 0; i < 20; i++) {
            add(i + 1);
            add(0);
        }
        for (int i = 0; i < 20; i++) {
            tie(2 * i, 2 * i + 1, 1);
        }
        assertThat(tied.resolve()).isTrue();

        for (int i = 0; i < 20; i++) {
            assertThat(bodies.velocityX[2 * i]).isEqualTo(0, within(1e-13));
            assertThat(bodies.velocityX[2 * i + 1]).isEqualTo(i + 1, within(1e-13));
        }
    }

    /** Impulses of a pair add up over a step; those of an instant begin with none. */
    @Test
    void theNextInstantBeginsAnew() {
        add(3);
        add(0);
        int pair = tie(0, 1, 1);
        tied.resolve();
        bodies.velocityX[0] = 3;
        bodies.velocityX[1] = 0;
        tied.clear();
        Impact impact = new Impact();
        impact.load(bodies, storage.pairs, pair);
        impact.friction = 0;
        impact.addPoint(1, 0, 0, 0, 2, 0);
        tied.add(pair, impact, 1);
        tied.resolve();

        assertThat(bodies.velocityX).startsWith(new double[] {0, 3}, within(1e-14));
        assertThat(storage.pairs.impulse[pair]).isEqualTo(6, within(1e-14));
    }
}
