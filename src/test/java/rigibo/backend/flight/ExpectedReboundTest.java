package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.collision.distance.Motion;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.impact.Impact;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * The predicted motion of a body that has met a pile, before the pile's solver resolves the impact.
 */
class ExpectedReboundTest {

    private final OneInstant instant = new OneInstant();
    private final Air air = instant.air;
    private final Trajectories paths = instant.paths;
    private final FlightImpacts impacts = instant.impacts;

    /** The motion predicted for the body that meets a pile; the other body belongs to it. */
    private Motion expectedOf(int lander) {
        instant.begin(1);
        air.pile(1 - lander);
        impacts.meet(0, 0);
        paths.land(lander, 0);
        impacts.expectRebound(0, lander);
        Motion motion = new Motion();
        paths.load(lander, motion);
        return motion;
    }

    /**
     * A pile is treated as a wall: it comes at 1 m/s, and what meets it at 2 m/s leaves at 1 + 3·½.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void aLanderIsExpectedToReboundAsFromAWall(int lander) {
        air.add(Air.disc(0, lander == 0 ? 2 : 1, 0.5));
        air.add(Air.disc(2, lander == 0 ? -1 : -2, 0.5));

        assertThat(expectedOf(lander).velocityXAt(1))
                .isEqualTo(lander == 0 ? -2.5 : 2.5, within(1e-15));
    }

    /** The hit is rough and beside the centre of a box, which would turn away; a wall does not. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void aPileDoesNotTurnAwayFromALander(int lander) {
        BodyDefinition disc = Air.disc(0, 2, 0.5).at(0, 0.75).material(new Material(1, 1, 0.5));
        BodyDefinition box =
                BodyDefinition.dynamic(Polygon.box(2, 2))
                        .mass(1)
                        .at(2, 0)
                        .material(new Material(1, 1, 0.5));
        air.add(lander == 0 ? disc : box);
        air.add(lander == 0 ? box : disc);

        assertThat(expectedOf(lander).velocityX).isEqualTo(-1, within(1e-14));
    }

    /** Without a contact point no impact is predicted: the body goes on. */
    @Test
    void withoutAPointALanderIsExpectedToGoOn() {
        air.add(Air.disc(0, 2, 0.5));
        air.add(Air.disc(3, -1, 0.5));
        assertThat(expectedOf(0).velocityX).isEqualTo(2);
    }

    /** The impact is computed at the predicted velocities, not at those in the columns. */
    @Test
    void aImpactIsOfTheVelocitiesExpected() {
        air.add(Air.disc(0, 2, 0.5).spin(1));
        air.add(Air.disc(2, -1, 0.5).spin(2));
        instant.begin(1);
        paths.land(0, 0);
        paths.expect(0, 7, 8, 9);
        paths.land(1, 0);
        paths.expect(1, -7, -8, -9);
        impacts.meet(0, 0);
        Impact impact = impacts.expectedImpact(0);

        assertThat(new double[] {impact.velocityAX, impact.velocityAY, impact.spinA})
                .containsExactly(7, 8, 9);
        assertThat(new double[] {impact.velocityBX, impact.velocityBY, impact.spinB})
                .containsExactly(-7, -8, -9);
        assertThat(impact.armAX[0]).isEqualTo(1, within(1e-15));
        assertThat(impact.armBX[0]).isEqualTo(-1, within(1e-15));
    }
}
