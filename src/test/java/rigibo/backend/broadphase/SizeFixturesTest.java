package rigibo.backend.broadphase;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Bodies;

/** The size of the fixture of a single body. */
class SizeFixturesTest {

    /** Sums of a few numbers of the size of 10. */
    private static final Offset<Double> ROUND_OFF = Offset.offset(1e-13);

    private static final double DT = 0.25;

    private final FilledStorage storage = new FilledStorage(new Contacts(), new Rotation());
    private final Bodies bodies = storage.bodies;
    private final SizeFixtures fixtures = new SizeFixtures(bodies);

    private int disc(double vx, double vy) {
        return storage.add(BodyDefinition.dynamic(new Circle(0.5)).at(3, 4).velocity(vx, vy));
    }

    private void assertFixture(int slot, double minX, double minY, double maxX, double maxY) {
        assertThat(bodies.fixtureMinX[slot]).isCloseTo(minX, ROUND_OFF);
        assertThat(bodies.fixtureMinY[slot]).isCloseTo(minY, ROUND_OFF);
        assertThat(bodies.fixtureMaxX[slot]).isCloseTo(maxX, ROUND_OFF);
        assertThat(bodies.fixtureMaxY[slot]).isCloseTo(maxY, ROUND_OFF);
    }

    @Test
    void staticBodyHasNoMargin() {
        int floor = storage.add(BodyDefinition.fixed(Polygon.box(4, 2)).at(1, -1));
        fixtures.sweep(floor, floor, 0, 0);
        fixtures.write(floor, floor, 0);
        assertFixture(floor, -1, -2, 3, 0);
    }

    @Test
    void bodyAtRestHasATenthOfItsRadiusAround() {
        int disc = disc(0, 0);
        fixtures.sweep(disc, disc, 0, 0);
        fixtures.write(disc, disc, 0);
        assertFixture(disc, 2.45, 3.45, 3.55, 4.55);
    }

    /** The way in a step, the margin, and three steps ahead, limited to a radius. */
    @Test
    void fastBodyHasItsWayAndARadiusAhead() {
        int disc = disc(8, 0);
        fixtures.sweep(disc, disc, DT, 0);
        fixtures.write(disc, disc, DT);
        assertFixture(disc, 2.45, 3.45, 3.55 + 8 * DT + 0.5, 4.55);
    }

    /**
     * The velocity alone leads 1 m up; 64·DT²/2 = 2 m of fall end 1 m lower. Both ends are covered.
     */
    @Test
    void wayIsCoveredWithTheAccelerationAndWithout() {
        int disc = disc(0, 4);
        bodies.accelerationY[disc] = -64;
        fixtures.sweep(disc, disc, DT, 0);
        fixtures.write(disc, disc, 0);
        assertFixture(disc, 2.45, 3.45 - 1, 3.55, 4.55 + 1);
    }

    /** A long box that turns reaches no farther than its corners. */
    @Test
    void turningReachesUpToTheBoundingCircle() {
        int box = storage.add(BodyDefinition.dynamic(Polygon.box(6, 0.8)).at(0, 0).spin(100));
        double radius = bodies.boundingRadius[box];
        assertThat(radius).isCloseTo(Math.hypot(3, 0.4), ROUND_OFF);
        fixtures.sweep(box, box, 0, fixtures.turned(box, DT));
        fixtures.write(box, box, 0);
        double reach = 1.1 * radius;
        assertFixture(box, -reach, -reach, reach, reach);
    }

    @Test
    void bodyIsCoveredUntilItLeavesItsMargin() {
        int disc = disc(0, 0);
        fixtures.sweep(disc, disc, 0, 0);
        fixtures.write(disc, disc, 0);
        bodies.x[disc] += 0.04;
        fixtures.sweep(disc, disc, 0, 0);
        assertThat(fixtures.isCovered(disc)).isTrue();
        bodies.x[disc] += 0.02;
        fixtures.sweep(disc, disc, 0, 0);
        assertThat(fixtures.isCovered(disc)).isFalse();
    }

    @Test
    void fixtureOfWhatWasFastIsLoose() {
        int disc = disc(100, 0);
        fixtures.sweep(disc, disc, DT, 0);
        fixtures.write(disc, disc, DT);
        assertThat(fixtures.isLoose(disc, disc, DT)).isFalse();
        bodies.velocityX[disc] = 0;
        fixtures.sweep(disc, disc, DT, 0);
        assertThat(fixtures.isCovered(disc)).isTrue();
        assertThat(fixtures.isLoose(disc, disc, DT)).isTrue();
    }
}
