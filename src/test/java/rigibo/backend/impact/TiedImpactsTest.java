package rigibo.backend.impact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

import java.util.Random;

/** Impacts at one instant that share bodies, against solutions by hand and the conditions asked. */
class TiedImpactsTest {

    private static final Effect[] ALL = {
        new Contacts(), new Rotation(), new Friction(), new Restitution(), new SurfaceSpeed()
    };

    /** Passes end at 10⁻¹⁴ of the approach; what they leave is larger by the rows' condition. */
    private static final double ROUND_OFF = 1e-12;

    private final FilledStorage storage = new FilledStorage(ALL);
    private final Bodies bodies = storage.bodies;
    private final Pairs pairs = storage.pairs;
    private final TiedImpacts tied = new TiedImpacts(bodies, pairs);

    private static BodyDefinition disc(double mass) {
        return BodyDefinition.dynamic(new Circle(1))
                .mass(mass)
                .inertia(mass / 2)
                .material(rubbing(0));
    }

    private static Material rubbing(double friction) {
        return new Material(1, friction, 0);
    }

    /** Discs of 1 m that touch, the normal from the one to the other; returns the impact. */
    private Impact touch(int pair, double angle) {
        double nx = Math.cos(angle);
        double ny = Math.sin(angle);
        pairs.normalX[pair] = nx;
        pairs.normalY[pair] = ny;
        Impact impact = new Impact();
        impact.load(bodies, pairs, pair);
        impact.addPoint(nx, ny, 0, 0, 2 * nx, 2 * ny);
        return impact;
    }

    private void tie(int a, int b, double angle, double elasticity) {
        int pair = storage.pair(a, b);
        tied.add(pair, touch(pair, angle), elasticity);
    }

    /**
     * One of three equal discs strikes two that touch each other at 30° from its way. With e = 1
     * and at once, J on each: v − 2J·cos 30° for the cue and J for the others; the normal speeds
     * turn round: J − (v − √3·J)·√3/2 = v·√3/2, so J = 2√3/5·v, and the cue goes back at v/5.
     */
    @Test
    void aSymmetricRackStaysSymmetric() {
        storage.add(disc(1).velocity(10, 0));
        storage.add(disc(1));
        storage.add(disc(1));
        tie(0, 1, Math.PI / 6, 1);
        tie(0, 2, -Math.PI / 6, 1);
        assertThat(tied.resolve()).isTrue();

        double impulse = 4 * Math.sqrt(3);
        assertThat(bodies.velocityX[0]).isCloseTo(-2, within(ROUND_OFF * 10));
        assertThat(bodies.velocityY[0]).isCloseTo(0, within(ROUND_OFF * 10));
        assertThat(Math.hypot(bodies.velocityX[1], bodies.velocityY[1]))
                .isCloseTo(impulse, within(ROUND_OFF * 10));
        assertThat(bodies.velocityY[1]).isCloseTo(-bodies.velocityY[2], within(ROUND_OFF * 10));
        assertThat(pairs.impulse).startsWith(new double[] {impulse, impulse}, within(1e-11));
    }

    /**
     * A row of three at once: the first two close at v, the others at 0 and may not close. With j₁
     * and j₂: 2j₁ − j₂ = (1 + e)v and 2j₂ = j₁, so j₁ = ⅔(1 + e)v.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void rowOfThreeSharesTheImpact(double elasticity) {
        storage.add(disc(1).velocity(3, 0));
        storage.add(disc(1));
        storage.add(disc(1));
        tie(0, 1, 0, elasticity);
        tie(1, 2, 0, elasticity);
        assertThat(tied.resolve()).isTrue();

        double passedOn = 1 + elasticity;
        assertThat(bodies.velocityX)
                .startsWith(new double[] {3 - 2 * passedOn, passedOn, passedOn}, within(1e-12));
        assertThat(pairs.impulse).startsWith(new double[] {2 * passedOn, passedOn}, within(1e-12));
    }

    /** Two discs of 2 kg meet one of 1 kg from both sides at 1 m/s: they stop, it stays. */
    @Test
    void whatIsMetFromBothSidesStays() {
        storage.add(disc(1));
        storage.add(disc(2).velocity(-1, 0));
        storage.add(disc(2).velocity(1, 0));
        tie(0, 1, 0, 0);
        tie(0, 2, Math.PI, 0);
        assertThat(tied.resolve()).isTrue();

        assertThat(bodies.velocityX).startsWith(new double[] {0, 0, 0}, within(ROUND_OFF));
        assertThat(pairs.impulse).startsWith(new double[] {2, 2}, within(ROUND_OFF));
    }

    /** By one impact alone: kₜ = 3 for a disc at a wall, 1/3 of the sliding sticks; else μ·jₙ. */
    @ParameterizedTest
    @ValueSource(doubles = {0.05, 10})
    void frictionSticksOrSlidesAsInASingleImpact(double friction) {
        storage.add(BodyDefinition.fixed(new Circle(1)).material(rubbing(friction)));
        storage.add(disc(1).velocity(-2, 1.5).material(rubbing(friction)));
        tie(0, 1, 0, 0.5);
        assertThat(tied.resolve()).isTrue();

        double tangent = Math.min(3 * friction, 0.5);
        assertThat(bodies.velocityX[1]).isCloseTo(1, within(ROUND_OFF));
        assertThat(bodies.velocityY[1]).isCloseTo(1.5 - tangent, within(ROUND_OFF));
        assertThat(bodies.spin[1]).isCloseTo(2 * tangent, within(ROUND_OFF));
        assertThat(pairs.impulse[0]).as("without friction's").isCloseTo(3, within(ROUND_OFF));
    }

    /** A disc that comes straight is taken along up to a third of the belt's speed. */
    @Test
    void frictionStartsFromTheSpeedOfTheBelt() {
        storage.add(BodyDefinition.fixed(new Circle(1)).material(rubbing(10).surfaceSpeed(-1.5)));
        storage.add(disc(1).velocity(-2, 0).material(rubbing(10)));
        tie(0, 1, 0, 0);
        assertThat(tied.resolve()).isTrue();

        assertThat(bodies.velocityY[1]).isCloseTo(-0.5, within(ROUND_OFF));
        assertThat(bodies.spin[1]).isCloseTo(1, within(ROUND_OFF));
    }

    /** The tangent stands in the middle of two points: a flat box is not turned by their sum. */
    @Test
    void flatBoxReboundsWithoutTurning() {
        storage.add(BodyDefinition.fixed(new Circle(1)).material(rubbing(1)));
        storage.add(disc(1).velocity(-4, 0.25).material(rubbing(1)));
        int pair = storage.pair(0, 1);
        Impact impact = touch(pair, 0);
        impact.points = 0;
        impact.addPoint(1, -1, 0, 0, 2, 0);
        impact.addPoint(1, 1, 0, 0, 2, 0);
        tied.add(pair, impact, 0.25);
        assertThat(tied.resolve()).isTrue();

        assertThat(bodies.velocityX[1]).isCloseTo(1, within(ROUND_OFF));
        assertThat(bodies.velocityY[1]).isCloseTo(0, within(ROUND_OFF));
        assertThat(bodies.spin[1]).isCloseTo(0, within(ROUND_OFF));
        assertThat(pairs.impulse[0]).isCloseTo(5, within(ROUND_OFF));
    }

    /** Between a driven disc and a wall there is no way out: it ends, and nothing runs away. */
    @Test
    void impactsWithoutAnAnswerLeaveNothingFast() {
        storage.add(BodyDefinition.kinematic(new Circle(1)).velocity(1, 0));
        storage.add(disc(1));
        storage.add(BodyDefinition.fixed(new Circle(1)));
        tie(0, 1, 0, 0);
        tie(1, 2, 0, 0);
        assertThat(tied.resolve()).isFalse();

        assertThat(Math.abs(bodies.velocityX[1])).isLessThanOrEqualTo(2 + ROUND_OFF);
    }

    @Test
    void nothingHappensWithoutImpacts() {
        storage.add(disc(1).velocity(1, 0));
        storage.add(disc(1));
        tie(0, 1, 0, 1);
        tied.clear();
        assertThat(tied.resolve()).isTrue();

        assertThat(bodies.velocityX).startsWith(1, 0);
    }

    /** Without friction or rotation there is no row but the normals'. */
    @Test
    void bodiesThatDoNotTurnAreStruckAllTheSame() {
        FilledStorage plain = new FilledStorage(new Contacts());
        plain.add(disc(1).velocity(2, 0));
        plain.add(disc(1));
        int pair = plain.pair(0, 1);
        plain.pairs.normalX[pair] = 1;
        Impact impact = new Impact();
        impact.load(plain.bodies, plain.pairs, pair);
        impact.addPoint(1, 0, 0, 0, 2, 0);
        TiedImpacts one = new TiedImpacts(plain.bodies, plain.pairs);
        one.add(pair, impact, 0);
        assertThat(one.resolve()).isTrue();

        assertThat(plain.bodies.velocityX).startsWith(new double[] {1, 1}, within(ROUND_OFF));
    }

    /**
     * A disc in the middle of a ring of others that come at random: every normal asks for its speed
     * or pushes not at all, every friction keeps to its cone and sticks inside it, momentum stays,
     * energy does not grow.
     */
    @Test
    void randomRingsSatisfyTheLaw() {
        int stuck = 0;
        int answered = 0;
        double work = 0;
        for (int seed = 1; seed <= 300; seed++) {
            Ring ring = new Ring(new Random(seed));
            answered += ring.strike(seed) ? 1 : 0;
            stuck += ring.stuck;
            work += ring.tied.work();
        }
        assertThat(answered).as("settled within the passes").isGreaterThan(290);
        // Passes alone take some 60 for rings of up to twelve rows; with elimination about ten do.
        assertThat(work / 300).isLessThan(20 * 12 * TiedImpacts.WORK_OF_ROW);
        assertThat(stuck).isGreaterThan(100);
    }

    /** Up to six discs round one. */
    private static final class Ring {

        private final FilledStorage storage = new FilledStorage(ALL);
        private final Bodies bodies = storage.bodies;
        private final TiedImpacts tied = new TiedImpacts(bodies, storage.pairs);
        private final Impact[] impacts;
        private final double elasticity;
        int stuck;

        Ring(Random random) {
            int others = 2 + random.nextInt(5);
            impacts = new Impact[others];
            elasticity = random.nextInt(3) == 0 ? 0 : Meet.between(random, 0, 0.4);
            double friction = random.nextInt(3) == 0 ? 0 : random.nextDouble() / 4;
            for (int i = 0; i <= others; i++) {
                storage.add(
                        disc(Meet.between(random, 0.5, 4))
                                .velocity(Meet.between(random, -1, 1), Meet.between(random, -1, 1))
                                .spin(Meet.between(random, -1, 1))
                                .material(rubbing(friction)));
            }
            for (int i = 0; i < others; i++) {
                double angle = 2 * Math.PI * i / others;
                int pair = storage.pair(0, i + 1);
                storage.pairs.normalX[pair] = Math.cos(angle);
                storage.pairs.normalY[pair] = Math.sin(angle);
                impacts[i] = new Impact();
                impacts[i].load(bodies, storage.pairs, pair);
                double nx = impacts[i].normalX;
                double ny = impacts[i].normalY;
                impacts[i].addPoint(nx, ny, 0, 0, 2 * nx, 2 * ny);
            }
        }

        /** Returns whether the passes settled; checks what came of them. */
        boolean strike(int seed) {
            double before = energy();
            double momentum = momentum();
            double spins = turning();
            for (int i = 0; i < impacts.length; i++) {
                tied.add(i, impacts[i], elasticity);
            }
            boolean isSettled = tied.resolve();
            assertThat(energy()).as("seed %d", seed).isLessThan(before * (1 + ROUND_OFF));
            assertThat(momentum()).as("seed %d", seed).isCloseTo(momentum, within(1e-11));
            // Discs of one size rub at equal arms: I·ω of the others grows as that of the middle.
            assertThat(turning()).as("seed %d", seed).isCloseTo(spins, within(1e-11));
            for (int i = 0; i < impacts.length && isSettled; i++) {
                assertRow(seed, i);
            }
            return isSettled;
        }

        private void assertRow(int seed, int pair) {
            Impact before = impacts[pair];
            Impact after = Meet.copy(before);
            after.velocityAX = bodies.velocityX[0];
            after.velocityAY = bodies.velocityY[0];
            after.spinA = bodies.spin[0];
            after.velocityBX = bodies.velocityX[pair + 1];
            after.velocityBY = bodies.velocityY[pair + 1];
            after.spinB = bodies.spin[pair + 1];
            double push = storage.pairs.impulse[pair];
            double target = Math.max(0, -elasticity * before.parting(0));
            assertThat(push).isNotNegative();
            assertThat(Math.min(push, after.parting(0) - target))
                    .as("seed %d, pair %d", seed, pair)
                    .isCloseTo(0, within(1e-11));
            double tangent = (after.spinB - before.spinB) / before.inverseInertiaB * -1;
            assertThat(Math.abs(tangent))
                    .as("seed %d, pair %d", seed, pair)
                    .isLessThanOrEqualTo(before.friction * push + 1e-11);
            double sliding =
                    TwoByTwo.pointY(after, 0) * before.normalX
                            - TwoByTwo.pointX(after, 0) * before.normalY;
            if (before.friction * push - Math.abs(tangent) > 1e-9) {
                stuck++;
                assertThat(sliding).as("seed %d, pair %d", seed, pair).isCloseTo(0, within(1e-11));
            } else {
                assertThat(sliding * tangent).isLessThanOrEqualTo(1e-11);
            }
        }

        private double energy() {
            double sum = 0;
            for (int slot = 0; slot <= impacts.length; slot++) {
                sum += bodies.kineticEnergy(slot);
            }
            return sum;
        }

        private double momentum() {
            double sum = 0;
            for (int slot = 0; slot <= impacts.length; slot++) {
                sum += bodies.mass[slot] * (bodies.velocityX[slot] + 2 * bodies.velocityY[slot]);
            }
            return sum;
        }

        /** Spin of the middle less that of the others: friction turns both of a pair alike. */
        private double turning() {
            double sum = bodies.inertia[0] * bodies.spin[0];
            for (int slot = 1; slot <= impacts.length; slot++) {
                sum -= bodies.inertia[slot] * bodies.spin[slot];
            }
            return sum;
        }
    }
}
