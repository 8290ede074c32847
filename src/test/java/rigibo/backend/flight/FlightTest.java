package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.Arrays;
import java.util.Random;

/** Impacts within a step in time order, compared with closed forms. */
class FlightTest {

    /** Impacts are resolved up to a nanometre before contact; a few of these errors add up. */
    private static final double PLACE = 2e-8;

    private static final double SPEED = 1e-12;

    private final Air air = new Air(Accuracy.EXACT);

    /**
     * With a gap of 1 m at 2 m/s, A stops after ½ s, and B goes on to the place where A would be
     * without it.
     */
    @Test
    void equalDiscsExchangeTheirVelocities() {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(3, 0, 1));
        air.fly(1);

        assertThat(air.bodies.x[0]).isEqualTo(1, within(PLACE));
        assertThat(air.bodies.x[1]).isEqualTo(4, within(PLACE));
        assertThat(air.bodies.velocityX[0]).isEqualTo(0, within(SPEED));
        assertThat(air.bodies.velocityX[1]).isEqualTo(2, within(SPEED));
        assertThat(air.storage.data.counters.impacts).isEqualTo(1);
        assertThat(air.pairs.impulse[air.pairOf(0, 1)]).isEqualTo(2, within(SPEED));
        assertThat(air.pairs.impacts[air.pairOf(0, 1)]).isEqualTo(1);
        assertThat(air.storage.data.counters.evaluations).isPositive();
    }

    /**
     * Equal elastic discs on a line move like points that pass through each other, sorted by place.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void discsOnALineGoOnAsIfTheyPassedThroughEachOther(long seed) {
        Random random = new Random(seed);
        int count = 6;
        double[] ends = new double[count];
        int[] slots = random.ints(0, count).distinct().limit(count).toArray();
        int[] slotAt = new int[count];
        for (int slot = 0; slot < count; slot++) {
            int rank = slots[slot];
            slotAt[rank] = slot;
            double gaps = 0.7 * rank + 0.1 * random.nextDouble();
            double speed = 4 * random.nextDouble() - 2;
            ends[rank] = gaps + speed;
            air.add(Air.disc(gaps + 2 * rank, speed, 1));
        }
        air.fly(1);
        Arrays.sort(ends);

        for (int rank = 0; rank < count; rank++) {
            assertThat(air.bodies.x[slotAt[rank]])
                    .as("seed %d, disc %d", seed, rank)
                    .isEqualTo(ends[rank] + 2 * rank, within(20 * PLACE));
        }
    }

    /** Between walls 4 m apart a disc of radius 1 m has 2 m to move: 6.5 m are 1 + 2 + 2 + 1.5. */
    @Test
    void bouncesBetweenWallsAsOftenAsItMeetsThem() {
        air.add(Air.wall(-2, -1));
        air.add(Air.wall(2, 1));
        air.add(Air.disc(0, 13, 1));
        air.fly(0.5);

        assertThat(air.bodies.x[2]).isEqualTo(1 - 1.5, within(PLACE));
        assertThat(air.bodies.velocityX[2]).isEqualTo(-13, within(SPEED * 13));
        assertThat(air.storage.data.counters.impacts).isEqualTo(3);
    }

    /** A fall from h = 1.25 m at g = 10 takes ½ s; at e = 1 the rebound takes as long. */
    @Test
    void aBallComesBackToItsHeight() {
        air.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        air.add(Air.body(new Circle(1), 1).at(0, 2.25));
        air.pull(0, -10);
        air.fly(1);

        assertThat(air.bodies.y[1]).isEqualTo(2.25, within(1e-7));
        assertThat(air.bodies.velocityY[1]).isEqualTo(0, within(1e-7));
    }

    /** The disc in the middle is hit from both sides at once and does not move. */
    @Test
    void tiesAreStruckAtOnce() {
        air.add(Air.disc(0, 0, 1));
        air.add(Air.disc(3, -2, 1));
        air.add(Air.disc(-3, 2, 1));
        air.fly(1);

        assertThat(air.bodies.x[0]).isEqualTo(0, within(1e-15));
        assertThat(air.bodies.x[1]).isEqualTo(3, within(PLACE));
        assertThat(air.bodies.x[2]).isEqualTo(-3, within(PLACE));
        assertThat(air.bodies.velocityX[0]).isEqualTo(0, within(SPEED));
    }

    /**
     * A flyer that hits a pile at ½ s belongs to it from then on; the pile's solver resolves the
     * impact.
     */
    @Test
    void aFlyerThatHitsAPileJoinsIt() {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(3, 0, 1));
        air.pile(1);
        air.fly(1);

        assertThat(air.bodies.piled[0]).isTrue();
        assertThat(air.bodies.pileTime[0]).isEqualTo(0.5, within(PLACE));
        assertThat(air.bodies.x[0]).isEqualTo(1, within(PLACE));
        assertThat(air.bodies.velocityX[0]).as("not yet").isEqualTo(2);
        assertThat(air.pairs.points[air.pairOf(0, 1)]).isEqualTo(1);
        assertThat(air.pairs.impacts[air.pairOf(0, 1)]).isEqualTo(1);
        assertThat(air.storage.data.counters.impacts).isZero();
    }

    /** A pile in motion at 1 m/s meets a flyer at 2 m/s after ⅓ s. */
    @Test
    void aPileIsMetWhereItIsByThen() {
        air.add(Air.disc(3, -1, 1));
        air.add(Air.disc(0, 2, 1));
        air.pile(0);
        air.fly(1);

        assertThat(air.bodies.pileTime[1]).isEqualTo(1.0 / 3, within(PLACE));
        assertThat(air.bodies.x[1]).isEqualTo(2.0 / 3, within(PLACE));
        assertThat(air.bodies.x[0]).as("moved by the pile's solver").isEqualTo(3);
    }

    @Test
    void aSleeperThatIsHitWakesIntoThePile() {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(3, 0, 1));
        air.bodies.awake[1] = false;
        air.storage.data.roster.isStale = true;
        air.fly(1);

        assertThat(air.bodies.awake[1]).isTrue();
        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.piled[0]).isTrue();
    }

    /**
     * The first disc stops at ½ s, 1.5 m ahead of the next one, which could meet it only ¼ s later.
     */
    @Test
    void whoFollowsALanderJoinsBeforeItMeetsIt() {
        air.add(Air.disc(0, 2, 0));
        air.add(Air.disc(3, 0, 0));
        air.add(Air.disc(-2.5, 2, 0));
        air.pile(1);
        air.fly(1);

        assertThat(air.bodies.piled[2]).isTrue();
        assertThat(air.bodies.pileTime[2]).isBetween(0.5 - PLACE, 0.75);
    }

    @Test
    void whatMeetsNothingJustFlies() {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.body(new Circle(1), 1).at(0, 5).velocity(0, 1));
        air.pull(0, -2);
        air.fly(1);

        assertThat(air.bodies.x[0]).isEqualTo(2);
        assertThat(air.bodies.y[0]).isEqualTo(-1);
        assertThat(air.bodies.y[1]).isEqualTo(5);
        assertThat(air.storage.data.counters.impacts).isZero();
    }

    /** It would rebound a hundred times between two walls, so the pile's solver takes over. */
    @Test
    void aPairThatMetTooOftenIsLeftToThePile() {
        Air few = bounceBetweenWalls(0.99);

        assertThat(few.bodies.piled[2]).isTrue();
        assertThat(few.pairs.impacts[few.pairOf(1, 2)]).isEqualTo(4);
    }

    /** At an elasticity of 1 it waits at the wall and keeps its speed. */
    @Test
    void aPairThatMetTooOftenWithoutLossWaits() {
        Air few = bounceBetweenWalls(1);

        assertThat(few.bodies.piled[2]).isFalse();
        assertThat(few.bodies.x[2]).isEqualTo(0.5, within(1e-8));
        assertThat(few.bodies.velocityX[2]).isEqualTo(-100, within(1e-11));
        assertThat(few.pairs.impacts[few.pairOf(1, 2)]).isEqualTo(4);
    }

    /** A disc of radius 1 m moves at 100 m/s in a gap that leaves half a metre on either side. */
    private static Air bounceBetweenWalls(double elasticity) {
        Air few = new Air(Accuracy.EXACT.withMaxImpactsPerPair(4));
        few.add(Air.wall(-1.5, -1));
        few.add(Air.wall(1.5, 1));
        few.add(Air.disc(0, 100, elasticity));
        few.fly(1);
        return few;
    }

    /** A body that comes after a waiting one waits behind it; nothing passes through. */
    @Test
    void whoComesAfterOneThatWaitsStaysBehindIt() {
        Air few = new Air(Accuracy.GAME.withMaxImpactsPerPair(4));
        few.add(Air.wall(-1.5, -1));
        few.add(Air.wall(1.5, 1));
        few.add(Air.disc(0, 100, 1).at(0, 0));
        few.add(Air.disc(0, 0, 1).at(0, 7).velocity(0, -10));
        few.fly(1);

        assertThat(few.bodies.y[3]).isGreaterThan(Math.sqrt(3) - 1e-3);
        assertThat(few.storage.data.counters.impacts).isEqualTo(8);
    }

    /**
     * Two discs exchange their speeds after ½ s. One of them then meets many pebbles, so that all
     * arrays by pair must grow; 1 s later the other one still strikes a third disc. Two neighbours
     * far away form the first pair.
     */
    @Test
    void whatIsStruckIsNotForgottenWhilePairsGrow() {
        air.add(Air.disc(50, 0, 1));
        air.add(Air.disc(52.05, 0, 1));
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(4, -2, 1));
        air.add(Air.disc(7, 0, 1));
        for (int i = 0; i < 100; i++) {
            air.add(BodyDefinition.fixed(new Circle(1e-3)).at(-2.9, 0.9));
        }
        int room = air.pairs.room();
        air.fly(2);

        assertThat(air.pairs.room()).isGreaterThan(room);
        assertThat(air.bodies.x[3]).isEqualTo(5, within(PLACE));
        assertThat(air.bodies.x[4]).isEqualTo(8, within(PLACE));
    }

    /**
     * Two bodies of a pile close at 1 m/s and search 1 m round themselves. One finds pebbles, so
     * that all arrays by pair must grow; then the other finds a disc that flies past and is struck
     * after ¼ s.
     */
    @Test
    void whatIsFoundByLookingRoundIsStruckWhilePairsGrow() {
        air.pile(air.add(Air.disc(0, 0.5, 1)));
        air.pile(air.add(Air.disc(2, -0.5, 1)));
        int beside = air.add(Air.body(new Circle(1), 1).at(4.8, 2.6));
        int striker = air.add(Air.body(new Circle(1), 1).at(7.3, 2.6).velocity(-2, 0));
        for (int i = 0; i < 100; i++) {
            air.add(BodyDefinition.fixed(new Circle(1e-3)).at(-1.9, 1.9));
        }
        air.fly(0.5);

        assertThat(air.pairOf(1, beside)).isGreaterThan(99);
        assertThat(air.bodies.x[beside]).isEqualTo(4.8 - 2 * 0.25, within(PLACE));
        assertThat(air.bodies.x[striker]).isEqualTo(6.8, within(PLACE));
    }

    /** A disc beside a body of a pile that is struck joins if it is within that body's reach. */
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 3.9})
    void whatTheStruckMayReachJoins(double gap) {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(2.5, 0, 1));
        air.add(Air.disc(4.5 + gap, 0, 1));
        air.pile(1);
        air.fly(0.5);

        // From ¼ s on the struck body moves at 2 m/s, or twice as fast where it is wedged: 1 m.
        assertThat(air.bodies.piled[2]).isEqualTo(gap < 1);
    }

    /** Elastic discs at random: energy and momentum are kept to round-off, and none overlap. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void aGasKeepsEnergyAndMomentum(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 25; i++) {
            air.add(
                    BodyDefinition.dynamic(new Circle(0.5))
                            .mass(0.5 + random.nextDouble())
                            .at(i % 5 * 1.5, i / 5 * 1.5)
                            .velocity(6 * random.nextDouble() - 3, 6 * random.nextDouble() - 3)
                            .material(new Material(1, 0, 1)));
        }
        double energy = energy();
        double momentum = momentum();
        for (int i = 0; i < 10; i++) {
            air.fly(0.1);
            assertThat(energy()).isEqualTo(energy, within(energy * 1e-12));
            assertThat(momentum()).isEqualTo(momentum, within(1e-11));
            for (int a = 0; a < 25; a++) {
                for (int b = 0; b < a; b++) {
                    double dx = air.bodies.x[a] - air.bodies.x[b];
                    double dy = air.bodies.y[a] - air.bodies.y[b];
                    assertThat(Math.hypot(dx, dy)).as("seed %d", seed).isGreaterThan(1 - 1e-12);
                }
            }
        }
        assertThat(air.storage.data.counters.impacts).isGreaterThan(10);
    }

    private double energy() {
        double sum = 0;
        for (int slot = 0; slot < air.bodies.slots.high; slot++) {
            sum += air.bodies.kineticEnergy(slot);
        }
        return sum;
    }

    private double momentum() {
        double sum = 0;
        for (int slot = 0; slot < air.bodies.slots.high; slot++) {
            double both = air.bodies.velocityX[slot] + 2 * air.bodies.velocityY[slot];
            sum += air.bodies.mass[slot] * both;
        }
        return sum;
    }
}
