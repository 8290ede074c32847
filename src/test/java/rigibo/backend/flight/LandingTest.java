package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** The effect of a body that lands within a step on those beside and behind it. */
class LandingTest {

    /** Impacts are resolved up to a nanometre before contact, m and s. */
    private static final double PLACE = 2e-8;

    private final Air air = new Air(Accuracy.EXACT);

    private void requireJoined(int slot, double time) {
        assertThat(air.bodies.piled[slot]).isTrue();
        assertThat(air.bodies.pileTime[slot]).isEqualTo(time, within(PLACE));
    }

    /** A disc in a pile that hardly gives way to a body of 1 kg. */
    private int heavy(double x, double velocityX, double elasticity) {
        int slot =
                air.add(
                        BodyDefinition.dynamic(new Circle(1))
                                .mass(1e6)
                                .at(x, 0)
                                .velocity(velocityX, 0)
                                .material(new Material(1, 0, elasticity)));
        air.pile(slot);
        return slot;
    }

    /**
     * Too slow to reach any other, a disc turns round after 0.1 s at 10⁻⁵ m; another one follows
     * 0.4 m behind at 2 m/s. They meet where 2·t − 0.4 = 10⁻⁵ − 10⁻⁴·(t − 0.1), and would meet
     * 2·10⁻⁵ s later if it went on.
     */
    @Test
    void whoFollowsMeetsTheReboundThatIsExpected() {
        int lander = air.add(Air.disc(0, 1e-4, 1));
        heavy(2 + 1e-5, 0, 1);
        int follower = air.add(Air.disc(-2 - 0.4, 2, 1));
        air.fly(0.3);

        requireJoined(lander, 0.1);
        requireJoined(follower, (0.4 + 2e-5) / (2 + 1e-4));
    }

    /**
     * After ¼ s a pile that comes at 4 m/s strikes a flyer at rest, and goes on on its predicted
     * path. The flyer leaves its own by twice 1 m in the remaining ¼ s.
     */
    @ParameterizedTest
    @CsvSource({"1.9, true", "2.1, false"})
    void whatIsBehindAFlyerThatAPileStrikesJoins(double gap, boolean joins) {
        int struck = air.add(Air.disc(0, 0, 0));
        heavy(3, -4, 0);
        int behind = air.add(Air.disc(-2 - gap, 0, 0));
        air.fly(0.5);

        requireJoined(struck, 0.25);
        assertThat(air.bodies.piled[behind]).isEqualTo(joins);
    }

    /**
     * The body comes on at 1 m/s: 0.1 m in the tenth of a second that is left when the slow one
     * lands.
     */
    @ParameterizedTest
    @CsvSource({"0.101, 1", "0.103, 0"})
    void whatIsBesideALanderIsAContactIfItMayStillMeetIt(double gap, int points) {
        int lander = air.add(Air.disc(0, 1e-5, 1));
        heavy(2 + 1e-6, 0, 1);
        int beside = air.add(Air.body(new Circle(1), 1).at(0, 2 + gap + 0.1).velocity(0, -1));
        air.pile(beside);
        air.fly(0.2);

        requireJoined(lander, 0.1);
        assertThat(air.pairs.points[air.pairOf(lander, beside)]).isEqualTo(points);
    }

    /**
     * A tilted box strikes a floor at an elasticity of 0 with a corner at −a from its centre: j =
     * v/(1 + a²/I). It goes on at j − v and ω = −a·j/I, which adds √2·ω at its corners. In the
     * remaining ⅛ s it may get twice as far as these speeds take it; a flyer is also reached from
     * as far as speeds take it in the ¼ s of the step.
     */
    @ParameterizedTest
    @CsvSource({"0.99, true", "1.01, false"})
    void whoIsBesideABoxThatTopplesJoins(double share, boolean joins) {
        double sin = 5 / 13.0;
        double cos = 12 / 13.0;
        air.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        int box =
                air.add(
                        Air.body(Polygon.box(2, 2), 0)
                                .angle(Math.asin(sin))
                                .at(0, sin + cos + 2 * 0.125)
                                .velocity(0, -2));
        // The pressing acceleration ends its bounces, but is too small to show in other figures.
        air.bodies.accelerationY[box] = -1e-7;
        double inertia = 2 / 3.0;
        double impulse = 2 / (1 + (cos - sin) * (cos - sin) / inertia);
        double spin = (cos - sin) * impulse / inertia;
        double speeds = 2 - impulse + spin * Math.sqrt(2);
        double gap = share * (2 * speeds * 0.125 + speeds * 0.25);
        // At (0.8, 0.6) m per m from its upper right corner, which is cos − sin beside its centre.
        int beside =
                air.add(
                        Air.body(new Circle(1), 0)
                                .at(
                                        cos - sin + 0.8 * (1 + gap),
                                        2 * (sin + cos) + 0.6 * (1 + gap)));
        air.fly(0.25);

        requireJoined(box, 0.125);
        assertThat(air.bodies.spin[box]).isEqualTo(-spin, within(1e-6));
        assertThat(air.bodies.piled[beside]).isEqualTo(joins);
        if (joins) {
            requireJoined(beside, 0.125);
        }
    }
}
