package rigibo.backend.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

/** The stages of contacts as parts of whole steps: discs of 1 m over a floor. */
class StepOfContactsTest {

    private static final double DT = 1.0 / 64;

    private static FilledStorage storage(ImpactMode mode) {
        FilledStorage storage =
                new FilledStorage(
                        Accuracy.GAME.withImpacts(mode),
                        new Contacts(),
                        new ContinuousImpacts(),
                        new Restitution(),
                        new Gravity(0, -8));
        storage.add(BodyDefinition.fixed(Polygon.box(100, 2)).at(0, -1));
        return storage;
    }

    private static int disc(FilledStorage storage, double x, double y, double velocityX) {
        return storage.add(
                BodyDefinition.dynamic(new Circle(1))
                        .mass(1)
                        .at(x, y)
                        .velocity(velocityX, 0)
                        .material(new Material(1, 0, 0)));
    }

    /** A pile is found, grouped and held up: a second's free fall would be 4 m. */
    @ParameterizedTest
    @EnumSource(ImpactMode.class)
    void whatLiesOnTheFloorStaysThere(ImpactMode mode) {
        FilledStorage storage = storage(mode);
        int lower = disc(storage, 0, 1, 0);
        int upper = disc(storage, 0, 3, 0);
        for (int i = 0; i < 64; i++) {
            storage.step(DT);
        }

        // Two thousandths of a width each at most are overlap that rests.
        assertThat(storage.bodies.y[lower]).isEqualTo(1, within(4e-3));
        assertThat(storage.bodies.y[upper]).isEqualTo(3, within(8e-3));
    }

    /** Without a look ahead only what touches has a manifold, with one all that may touch. */
    @ParameterizedTest
    @EnumSource(ImpactMode.class)
    void manifoldsReachAsFarAsTheModeLooks(ImpactMode mode) {
        FilledStorage storage = storage(mode);
        int disc = disc(storage, 0, 1.01, 0);
        storage.bodies.velocityY[disc] = -1;
        storage.step(DT / 64);

        int pair = storage.pairs.index.find(0, disc);
        assertThat(storage.pairs.points[pair]).as("0.01 m, at 1 m/s for 1/4096 s").isZero();
        storage.step(DT);
        assertThat(storage.pairs.points[pair] > 0).isEqualTo(mode != ImpactMode.DISCRETE);
    }

    /**
     * A body struck in a pile moves farther than predicted; at the end of the step its fixture has
     * followed.
     */
    @Test
    void fixturesCoverWhereAllIsAtTheEnd() {
        FilledStorage storage = storage(ImpactMode.EVENTS);
        int struck = disc(storage, 0, 1, 0);
        for (int i = 0; i < 4; i++) {
            storage.step(DT);
        }
        int striker = disc(storage, -2.5, 1, 100);
        storage.step(DT);

        Bodies bodies = storage.bodies;
        assertThat(bodies.x[struck]).as("struck").isGreaterThan(0.1);
        for (int slot : new int[] {struck, striker}) {
            assertThat(bodies.fixtureMinX[slot]).isLessThanOrEqualTo(bodies.x[slot] - 1);
            assertThat(bodies.fixtureMaxX[slot]).isGreaterThanOrEqualTo(bodies.x[slot] + 1);
            assertThat(bodies.fixtureMinY[slot]).isLessThanOrEqualTo(bodies.y[slot] - 1);
            assertThat(bodies.fixtureMaxY[slot]).isGreaterThanOrEqualTo(bodies.y[slot] + 1);
        }
    }
}
