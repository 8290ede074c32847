package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.storage.DataStorage;

/**
 * A box of 1 m on the ground with a radius of 1 m, in a step of half a second under 4 m/s². The
 * pull may move it by 1 m, and a thousandth of its width is not visible.
 */
class StraysTest {

    private static final double STEP = 0.5;
    private static final double PULL = 4;

    private final DataStorage data = new DataStorage(Effects.of(new Contacts(), new Rotation()));
    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final Strays strays = new Strays(data, motions, island.contacts);
    private int row;

    @BeforeEach
    void lay() {
        data.bodies.smallestWidth[0] = 1;
        data.bodies.accelerationY[0] = -PULL;
        data.bodies.outline[0] = Polygon.box(1, 1).outline();
        island.begin(Motions.FEW + 1);
        island.body(1, 1, 1);
        row = island.onGround(1, 0.5, 0.5);
        island.contacts.points[row] = 1;
        strays.begin(STEP);
    }

    private void go(double velocityX, double velocityY, double spin) {
        motions.data[Motions.STRIDE + Motions.VX] = velocityX;
        motions.data[Motions.STRIDE + Motions.VY] = velocityY;
        motions.data[Motions.STRIDE + Motions.SPIN] = spin;
    }

    /** 1 m and 1 mm in half a second are 2.002 m/s, along any axis or by turning. */
    @ParameterizedTest
    @CsvSource({
        "0, -2, 0, false",
        "0, -2.003, 0, true",
        "2.003, 0, 0, true",
        "0, 0, -2, false",
        "0, 0, -2.003, true",
        "1, 0.5, 0.4, false",
        "1, 0.5, 0.6, true"
    })
    void whoGoesFartherThanItsPullStrays(double x, double y, double spin, boolean isAny) {
        go(x, y, spin);
        assertThat(strays.areAny(STEP)).isEqualTo(isAny);
        assertThat(strays.mayLackPoint(row)).isEqualTo(isAny);
    }

    /** In less time it gets less far; the way behind it counts. */
    @Test
    void whatItHasGoneCounts() {
        go(3, 0, 0);
        assertThat(strays.areAny(0.3)).isFalse();
        motions.data[Motions.STRIDE + Motions.DX] = 0.2;
        assertThat(strays.areAny(0.3)).isTrue();
        motions.data[Motions.STRIDE + Motions.DX] = 0;
        motions.data[Motions.STRIDE + Motions.TURN] = 0.2;
        assertThat(strays.areAny(0.3)).isTrue();
    }

    /** Among few bodies landings are followed as they come. */
    @Test
    void noneOfFewStrays() {
        motions.count--;
        go(30, 0, 0);
        assertThat(strays.areAny(STEP)).isFalse();
    }

    /** The motion of the step's start was predicted. */
    @Test
    void whoGoesOnDoesNotStray() {
        go(-30, 40, 5);
        strays.begin(STEP);
        assertThat(strays.areAny(STEP)).isFalse();
    }

    @Test
    void twoPointsLackNone() {
        island.contacts.points[row] = 2;
        go(30, 0, 0);
        assertThat(strays.areAny(STEP)).isTrue();
        assertThat(strays.mayLackPoint(row)).isFalse();
    }

    /** A disc lands with one point in any direction. */
    @Test
    void discsLackNone() {
        data.bodies.outline[0] = new Circle(0.5).outline();
        go(30, 0, 0);
        assertThat(strays.areAny(STEP)).isTrue();
        assertThat(strays.mayLackPoint(row)).isFalse();
    }
}
