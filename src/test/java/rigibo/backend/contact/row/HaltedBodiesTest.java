package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/** Driven bodies that {@link RowBuilder} packs as at rest: those that press in vain. */
class HaltedBodiesTest {

    private final StoredIsland island = StoredIsland.turning();

    /**
     * A body of 1 m width on a press that rises at 1 m/s. The press counts as at rest, like the
     * ground, if it is deep in a body that moves along at less than half of its speed.
     */
    @ParameterizedTest
    @CsvSource({
        "true, -0.051, 0.4, true",
        "true, -0.051, 0.6, false",
        "true, -0.049, 0, false",
        "false, -0.051, 0, false",
        "true, -0.051, 1.2, false"
    })
    void drivenBodyThatPressesInVainStandsStill(
            boolean touchedBefore, double gap, double speed, boolean isHalted) {
        int driven = island.body(BodyDefinition.kinematic(Polygon.box(2, 2)).velocity(0, 1));
        int a = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1.5));
        island.bodies.velocityY[a] = speed;
        int pair = island.contact(driven, a, Math.PI / 2);
        island.point(pair, 0.1, 1, gap);
        island.pairs.touchedBefore[pair] = touchedBefore;
        island.builder.build(0, 0.01);
        assertThat(island.contacts.bodyA[0] == 0).isEqualTo(isHalted);
        assertThat(island.contacts.bodyB[0]).isNotZero();
    }

    /** With the bodies exchanged, and at either of the points. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 2, -2, 0.5})
    void drivenBodyMayBeTheSecond(double spin) {
        int a = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1.5));
        int driven = island.body(BodyDefinition.kinematic(Polygon.box(2, 2)).velocity(0, 1));
        // Its centre moves along at 0.6 m/s; the point that turns downwards does not.
        island.bodies.velocityY[a] = spin == 0 ? 0.3 : 0.6;
        island.bodies.spin[a] = spin;
        int pair = island.contact(a, driven, -Math.PI / 2);
        island.point(pair, -0.3, 1, -0.06);
        island.point(pair, 0.3, 1, -0.06);
        island.pairs.touchedBefore[pair] = true;
        island.builder.build(0, 0.01);
        assertThat(island.contacts.bodyB[0]).isZero();
        assertThat(island.contacts.bodyA[0]).isNotZero();
    }

    /** A driven body that withdraws presses nothing. */
    @Test
    void drivenBodyThatWithdrawsIsNotHalted() {
        int driven = island.body(BodyDefinition.kinematic(Polygon.box(2, 2)).velocity(0, -1));
        int a = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1.5));
        island.bodies.velocityY[a] = -3;
        int pair = island.contact(driven, a, Math.PI / 2);
        island.point(pair, 0.1, 1, -0.06);
        island.pairs.touchedBefore[pair] = true;
        island.builder.build(0, 0.01);
        assertThat(island.contacts.bodyA[0]).isNotZero();
    }
}
