package rigibo.backend.impact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Bodies;

import java.util.Random;
import java.util.function.Function;

/** Ties against single blows, whose law is tested by itself, and what holds ties in bounds. */
class TiedLimitsTest {

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
        Impact blow = new Impact();
        blow.load(bodies, storage.pairs, pair);
        blow.friction = 0;
        blow.addPoint(1, 0, 0, 0, 2, 0);
        tied.add(pair, blow, elasticity);
        return pair;
    }

    /** Writes a blow's bodies into the columns; a tie of it alone then has the law's answer. */
    private void write(Impact blow) {
        bodies.inverseMass[0] = blow.inverseMassA;
        bodies.inverseMass[1] = blow.inverseMassB;
        bodies.inverseInertia[0] = blow.inverseInertiaA;
        bodies.inverseInertia[1] = blow.inverseInertiaB;
        bodies.velocityX[0] = blow.velocityAX;
        bodies.velocityY[0] = blow.velocityAY;
        bodies.spin[0] = blow.spinA;
        bodies.velocityX[1] = blow.velocityBX;
        bodies.velocityY[1] = blow.velocityBY;
        bodies.spin[1] = blow.spinB;
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
    void aTieOfOneIsTheBlowAlone() {
        assertThat(answeredAsAlone(5_000, 5, TiedLimitsTest::closing)).isGreaterThan(4000);
    }

    /** Without friction two points have one answer. */
    @Test
    void aTieOfTwoPointsIsTheBlowAlone() {
        assertThat(answeredAsAlone(3_000, 6, TiedLimitsTest::smoothOnTwoPoints))
                .isGreaterThan(2500);
    }

    private static Impact closing(Random random) {
        Impact blow = Meet.any(random, 1);
        return blow.parting(0) < 0 ? blow : closing(random);
    }

    private static Impact smoothOnTwoPoints(Random random) {
        Impact blow = Meet.any(random, 2);
        blow.friction = 0;
        return blow;
    }

    /** How many blows the tie answered; each of those as the impact law answers it. */
    private int answeredAsAlone(int count, long seed, Function<Random, Impact> draw) {
        add(0);
        add(0);
        int pair = storage.pair(0, 1);
        Random random = new Random(seed);
        int answered = 0;
        for (int i = 0; i < count; i++) {
            Impact blow = draw.apply(random);
            write(blow);
            tied.clear();
            tied.add(pair, blow, blow.elasticity);
            if (tied.resolve()) {
                answered++;
                new ImpactLaw().resolve(blow);
                // Ten passes to a digit, where rows hang together most.
                assertThat(off(blow)).as("impact %d, seed %d", i, seed).isLessThan(1e-8);
            }
        }
        return answered;
    }

    /**
     * Two discs are struck together by two that are driven, at 1 m/s and e = 1: each would leave at
     * 2 m/s, the two would close at 4, and nothing can part them. The impulses are halved: no row
     * may be more than twice as fast as the fastest was.
     */
    @Test
    void blowsWithoutAnAnswerLeaveNoRowTwiceAsFast() {
        add(0);
        add(0);
        drive(1);
        drive(-1);
        tie(0, 1, 1);
        tie(2, 0, 1);
        int last = storage.pair(1, 3);
        storage.pairs.normalX[last] = 1;
        Impact blow = new Impact();
        blow.load(bodies, storage.pairs, last);
        blow.friction = 0;
        blow.addPoint(1, 0, 0, 0, 2, 0);
        tied.add(last, blow, 1);
        assertThat(tied.resolve()).isFalse();

        // Round-off of impulses that grew with each of 300 passes.
        assertThat(bodies.velocityX).startsWith(new double[] {1, -1, 1, -1}, within(1e-9));
    }

    /** More rows than there was room for, each of a blow of its own: equal discs exchange. */
    @Test
    void holdsAsManyBlowsAsFallOnTheInstant() {
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
        Impact blow = new Impact();
        blow.load(bodies, storage.pairs, pair);
        blow.friction = 0;
        blow.addPoint(1, 0, 0, 0, 2, 0);
        tied.add(pair, blow, 1);
        tied.resolve();

        assertThat(bodies.velocityX).startsWith(new double[] {0, 3}, within(1e-14));
        assertThat(storage.pairs.impulse[pair]).isEqualTo(6, within(1e-14));
    }
}
