package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.FilledStorage;
import rigibo.backend.collision.distance.Motion;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

/** Paths within a step: parabolas, exponentials under drag, and straight lines outside flight. */
class TrajectoriesTest {

    /** Sums of a few terms of the order of 10. */
    private static final double ROUND_OFF = 1e-14;

    private final FilledStorage storage = new FilledStorage(new Contacts(), new Rotation());
    private final Bodies bodies = storage.bodies;
    private final Trajectories paths = new Trajectories(bodies);
    private final Motion motion = new Motion();

    /**
     * Throws a disc from (1, 2) at (3, 4) m/s under (½, −8) m/s², with angle 0.1, 5 rad/s and 6
     * rad/s².
     */
    @BeforeEach
    void throwOne() {
        storage.add(
                BodyDefinition.dynamic(Polygon.box(1, 1))
                        .at(1, 2)
                        .angle(0.1)
                        .velocity(3, 4)
                        .spin(5));
        pull(bodies, 0);
        bodies.angularAcceleration[0] = 6;
        paths.begin();
    }

    private static void pull(Bodies bodies, int slot) {
        bodies.accelerationX[slot] = 0.5;
        bodies.accelerationY[slot] = -8;
    }

    /** After ½ s: (1 + 1.5 + 1/16, 2 + 2 − 1) m, (3.25, 0) m/s, 0.1 + 2.5 + 0.75 rad, 8 rad/s. */
    private void assertHalfASecondOn(int slot) {
        assertThat(bodies.x[slot]).isEqualTo(2.5625, within(ROUND_OFF));
        assertThat(bodies.y[slot]).isEqualTo(3, within(ROUND_OFF));
        assertThat(bodies.velocityX[slot]).isEqualTo(3.25, within(ROUND_OFF));
        assertThat(bodies.velocityY[slot]).isEqualTo(0, within(ROUND_OFF));
        assertThat(bodies.angle[slot]).isEqualTo(3.35, within(ROUND_OFF));
        assertThat(bodies.cos[slot]).isEqualTo(Math.cos(3.35), within(ROUND_OFF));
        assertThat(bodies.spin[slot]).isEqualTo(8, within(ROUND_OFF));
    }

    @Test
    void aFlyerGoesItsParabola() {
        paths.advance(0, 0.5);

        assertHalfASecondOn(0);
        assertThat(paths.since(0)).isEqualTo(0.5);
    }

    @Test
    void allFlyersGoTheirParabolas() {
        paths.advanceAll(storage.data.roster, 0.5);

        assertHalfASecondOn(0);
        assertThat(paths.since(0)).isEqualTo(0.5);
    }

    /** Two advances, and one of no time. */
    @Test
    void goesOnFromWhereItsColumnsAre() {
        paths.advance(0, 0.25);
        paths.advance(0, 0.25);
        paths.advance(0, 0.5);

        assertHalfASecondOn(0);
    }

    @Test
    void aStepBeginsAtItsStart() {
        paths.advance(0, 0.5);
        paths.begin();

        assertThat(paths.since(0)).isZero();
    }

    @Test
    void thePathIsWhatTheBodyThenGoes() {
        paths.advance(0, 0.25);
        paths.load(0, motion);
        Pose pose = new Pose();
        paths.poseAt(0, 0.5, pose);
        paths.advance(0, 0.5);

        assertHalfASecondOn(0);
        assertThat(motion.startTime).isEqualTo(0.25);
        assertThat(motion.velocityXAt(0.5)).isEqualTo(3.25, within(ROUND_OFF));
        assertThat(motion.spinAt(0.5)).isEqualTo(8, within(ROUND_OFF));
        assertThat(pose.x).isEqualTo(bodies.x[0], within(ROUND_OFF));
        assertThat(pose.y).isEqualTo(bodies.y[0], within(ROUND_OFF));
        assertThat(pose.sin).isEqualTo(bodies.sin[0], within(ROUND_OFF));
    }

    /** An angular acceleration alone also turns a body. */
    @Test
    void beginsToTurnFromRest() {
        bodies.spin[0] = 0;
        paths.advance(0, 0.5);

        assertThat(bodies.angle[0]).isEqualTo(0.85, within(ROUND_OFF));
        assertThat(bodies.spin[0]).isEqualTo(3);
    }

    @Test
    void keepsOnTurningWithoutATorque() {
        bodies.angularAcceleration[0] = 0;
        paths.advance(0, 0.5);

        assertThat(bodies.angle[0]).isEqualTo(2.6, within(ROUND_OFF));
        assertThat(bodies.spin[0]).isEqualTo(5);
    }

    /** x = x₀ + v·E₁ + a·E₂, E₁ = (1 − e^(−kτ))/k, E₂ = (τ − E₁)/k; v = a/k + (v₀ − a/k)e^(−kτ). */
    @Test
    void dragSlowsAFlyerAndNotAPile() {
        FilledStorage air = new FilledStorage(new Contacts(), new Drag());
        Material dragged = Material.DEFAULT.drag(2);
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(1)).material(dragged);
        air.add(disc.at(1, 2).velocity(3, 4));
        air.add(disc.at(9, 2).velocity(3, 4));
        pull(air.bodies, 0);
        pull(air.bodies, 1);
        air.bodies.piled[1] = true;
        Trajectories ways = new Trajectories(air.bodies);
        ways.begin();
        ways.load(1, motion);
        ways.advanceAll(air.data.roster, 0.5);

        double e1 = (1 - Math.exp(-1)) / 2;
        double e2 = (0.5 - e1) / 2;
        assertThat(air.bodies.x[0]).isEqualTo(1 + 3 * e1 + 0.5 * e2, within(ROUND_OFF));
        assertThat(air.bodies.y[0]).isEqualTo(2 + 4 * e1 - 8 * e2, within(ROUND_OFF));
        assertThat(air.bodies.velocityY[0]).isEqualTo(-4 + 8 * Math.exp(-1), within(ROUND_OFF));
        assertThat(air.bodies.x[1]).isEqualTo(9);
        assertThat(motion.velocityXAt(0.5)).isEqualTo(3);
    }

    @Test
    void whatLandsStaysAndIsExpectedToGoStraightOn() {
        paths.advance(0, 0.25);
        paths.land(0, 0.25);
        paths.load(0, motion);

        assertThat(bodies.piled[0]).isTrue();
        assertThat(bodies.pileTime[0]).isEqualTo(0.25);
        assertThat(paths.hasLanded(0)).isTrue();
        assertThat(paths.isFlyer(0)).isFalse();
        assertThat(motion.startTime).isEqualTo(0.25);
        assertThat(motion.velocityXAt(0.5)).isEqualTo(bodies.velocityX[0]);
        assertThat(motion.velocityYAt(0.5)).isEqualTo(bodies.velocityY[0]);
        assertThat(motion.spinAt(0.5)).isEqualTo(bodies.spin[0]);
        double x = bodies.x[0];
        double angle = bodies.angle[0];
        paths.advanceAll(storage.data.roster, 1);
        assertThat(bodies.x[0]).isEqualTo(x);
        assertThat(bodies.angle[0]).isEqualTo(angle);
    }

    @Test
    void anExpectedReboundReplacesTheVelocity() {
        paths.land(0, 0.25);
        paths.expect(0, -1, -2, -3);
        paths.load(0, motion);

        assertThat(motion.velocityXAt(0.5)).isEqualTo(-1);
        assertThat(motion.velocityYAt(0.5)).isEqualTo(-2);
        assertThat(motion.spinAt(0.5)).isEqualTo(-3);
        assertThat(bodies.velocityX[0]).as("the pile's solver sees to it").isEqualTo(3);
    }

    /** It waits at any speed and acceleration, and goes on in the next step. */
    @Test
    void whatStandsWaitsForTheNextStep() {
        paths.advance(0, 0.25);
        paths.stand(0);
        double x = bodies.x[0];
        double y = bodies.y[0];
        double angle = bodies.angle[0];
        paths.load(0, motion);
        Pose pose = new Pose();
        motion.poseAt(0.5, pose);
        paths.advance(0, 0.5);
        paths.advanceAll(storage.data.roster, 0.5);

        assertThat(new double[] {bodies.x[0], bodies.y[0], bodies.angle[0]})
                .containsExactly(x, y, angle);
        assertThat(new double[] {pose.x, pose.y, motion.angleAt(0.5)}).containsExactly(x, y, angle);
        assertThat(motion.velocityXAt(0.5)).isZero();
        assertThat(motion.velocityYAt(0.5)).isZero();
        assertThat(motion.spinAt(0.5)).isZero();
        assertThat(bodies.velocityX[0]).isEqualTo(3.125);
        paths.begin();
        assertThat(paths.stands(0)).isFalse();
    }

    /**
     * The body was to rest at ½ s, where its columns are; at ¼ s it was ¼ s of its velocity before.
     */
    @Test
    void landsEarlierWhereItWasThen() {
        paths.land(0, 0.5);
        paths.landEarlier(0, 0.25);

        assertThat(bodies.x[0]).isEqualTo(1 - 0.75);
        assertThat(bodies.y[0]).isEqualTo(2 - 1.0);
        assertThat(bodies.angle[0]).isEqualTo(0.1 - 1.25, within(ROUND_OFF));
        assertThat(bodies.pileTime[0]).isEqualTo(0.25);
    }

    @Test
    void doesNotLandLaterNorUnlessItFlewInThisStep() {
        paths.land(0, 0.5);
        paths.landEarlier(0, 0.5);
        paths.landEarlier(0, 0.75);
        assertThat(bodies.pileTime[0]).isEqualTo(0.5);
        assertThat(bodies.x[0]).isEqualTo(1);

        paths.begin();
        paths.landEarlier(0, 0.25);
        assertThat(bodies.pileTime[0]).isEqualTo(0.5);
        assertThat(paths.hasLanded(0)).isFalse();
    }

    /** A body of a pile goes on at its velocity, from its own time on. */
    @Test
    void aPileIsPredictedByItsVelocity() {
        bodies.piled[0] = true;
        bodies.pileTime[0] = 0.125;
        paths.load(0, motion);

        assertThat(paths.isFlyer(0)).isFalse();
        assertThat(motion.startTime).isEqualTo(0.125);
        assertThat(motion.velocityYAt(0.5)).isEqualTo(4);
        assertThat(motion.spinAt(0.5)).isEqualTo(5);
    }

    @Test
    void aSleeperStandsStill() {
        bodies.awake[0] = false;
        paths.load(0, motion);

        assertThat(paths.isFlyer(0)).isFalse();
        assertThat(motion.velocityXAt(0.5)).isZero();
        assertThat(motion.velocityYAt(0.5)).isZero();
        assertThat(motion.spinAt(0.5)).isZero();
        paths.land(0, 0.25);
        assertThat(bodies.piled[0]).isFalse();
    }

    @Test
    void whatIsDrivenGoesAsTold() {
        storage.add(BodyDefinition.kinematic(new Circle(1)).velocity(7, 8).spin(9));
        paths.begin();
        paths.load(1, motion);

        assertThat(paths.isFlyer(1)).isFalse();
        assertThat(motion.startTime).isZero();
        assertThat(motion.velocityXAt(0.5)).isEqualTo(7);
        assertThat(motion.velocityYAt(0.5)).isEqualTo(8);
        assertThat(motion.spinAt(0.5)).isEqualTo(9);
    }

    /** There are more bodies than the first capacity. */
    @Test
    void eachOfManyBodiesHasItsOwnTime() {
        for (int i = 1; i < 40; i++) {
            storage.add(BodyDefinition.dynamic(new Circle(1)).at(5 * i, 0).velocity(i, 0).spin(i));
        }
        paths.begin();
        paths.advance(39, 0.5);
        paths.land(38, 0.25);
        paths.load(38, motion);

        assertThat(bodies.x[39]).isEqualTo(195 + 19.5);
        assertThat(paths.since(39)).isEqualTo(0.5);
        assertThat(motion.velocityXAt(1)).isEqualTo(38);
        assertThat(motion.spinAt(1)).isEqualTo(38);
        paths.begin();
        assertThat(paths.since(39)).isZero();
        assertThat(paths.hasLanded(38)).isFalse();
    }
}
