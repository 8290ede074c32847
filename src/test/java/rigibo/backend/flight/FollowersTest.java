package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * A disc falls on a column of discs that moves down as one, until the ground stops it within the
 * step. It would miss the column by a hair if that went on, and strikes it because it does not.
 */
class FollowersTest {

    private static final double DT = 1.0 / 60;
    private static final double RADIUS = 0.25;
    private static final double SINKS = 1.5;
    private static final double FALLS = 20;
    private static final double MISSES_BY = 0.002;

    /** Passes may miss three thousandths of a width in a crowd, and less among few. */
    private static final double OVERLAP = 0.003 * 2 * RADIUS;

    @ParameterizedTest
    @ValueSource(ints = {3, 6, 12})
    void whatFollowsAColumnThatIsStoppedStrikesIt(int discs) {
        Effects effects =
                Effects.of(new Gravity(0, -9.81), new Contacts(), new ContinuousImpacts());
        Pool pool = new Pool(effects, Accuracy.GAME);
        Material dead = new Material(1, 0, 0);
        pool.add(BodyDefinition.fixed(Polygon.box(10, 1)).at(0, -0.5).material(dead));
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(RADIUS)).material(dead);
        RigidBody top = null;
        for (int i = 0; i < discs; i++) {
            top = pool.add(disc.at(0, RADIUS + 2 * RADIUS * i).velocity(0, -SINKS));
        }
        double gap = (FALLS - SINKS) * DT + MISSES_BY;
        RigidBody follower = pool.add(disc.at(0, top.y() + 2 * RADIUS + gap).velocity(0, -FALLS));
        pool.step(DT);
        double apart = follower.y() - top.y() - 2 * RADIUS;
        // The column has moved by a hair at most, and would have gone 25 mm.
        assertThat(top.y()).isGreaterThan(RADIUS + 2 * RADIUS * (discs - 1) - OVERLAP * discs);
        assertThat(apart).isGreaterThan(-OVERLAP);
    }
}
