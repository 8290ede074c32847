package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

class LockedAxesTest {

    private final StoredIsland island = StoredIsland.turning();
    private final Motions motions = island.motions;
    private final LockedAxes locked = new LockedAxes(island.bodies, motions);

    @BeforeEach
    void lay() {
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1));
        island.body(box.velocity(1, 2));
        island.body(box.velocity(3, 4).lockX());
        island.body(box.velocity(5, 6).lockY());
        island.body(box.velocity(7, 8));
        motions.clear(island.bodies);
        motions.offset(island.bodies, 0);
    }

    private double of(int slot, int column) {
        return motions.data[motions.offset(island.bodies, slot) + column];
    }

    /** P of P·M⁻¹·P: 0 along a locked axis. */
    @Test
    void lockedAxesAreProjectedOut() {
        for (int slot = 0; slot < 4; slot++) {
            int at = motions.offset(island.bodies, slot);
            assertThat(locked.freedomX(at)).isEqualTo(slot == 1 ? 0 : 1);
            assertThat(locked.freedomY(at)).isEqualTo(slot == 2 ? 0 : 1);
        }
        locked.hold();
        double[] x = {1, 0, 5, 7};
        double[] y = {2, 4, 0, 8};
        for (int slot = 0; slot < 4; slot++) {
            assertThat(of(slot, Motions.VX)).isEqualTo(x[slot]);
            assertThat(of(slot, Motions.VY)).isEqualTo(y[slot]);
        }
    }

    @Test
    void onlyPackedBodiesCount() {
        assertThat(locked.areAny()).isFalse();
        motions.offset(island.bodies, 3);
        assertThat(locked.areAny()).isFalse();
        motions.offset(island.bodies, 2);
        assertThat(locked.areAny()).isTrue();
        motions.clear(island.bodies);
        motions.offset(island.bodies, 1);
        motions.offset(island.bodies, 3);
        assertThat(locked.areAny()).isTrue();
    }

    /** A driven body follows its own motion. */
    @Test
    void drivenBodiesAreNotHeld() {
        int driven = island.body(BodyDefinition.kinematic(Polygon.box(1, 1)).velocity(2, 0));
        motions.offset(island.bodies, driven);
        island.bodies.lockedX[driven] = true;
        locked.hold();
        assertThat(of(driven, Motions.VX)).isEqualTo(2);
    }
}
