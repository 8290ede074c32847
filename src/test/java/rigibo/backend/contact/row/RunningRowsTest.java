package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

class RunningRowsTest {

    /** Two belts that meet run against each other, so that their speeds add. */
    @Test
    void speedsOfBothSurfacesAdd() {
        StoredIsland island =
                new StoredIsland(
                        Effects.of(
                                new Contacts(),
                                new Rotation(),
                                new Friction(),
                                new SurfaceSpeed()));
        double[] speeds = {0, 0, 2, -0.5};
        for (double speed : speeds) {
            Material belt = Material.DEFAULT.surfaceSpeed(speed);
            island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).material(belt));
        }
        PackedContacts contacts = island.contacts;
        RowBuilder builder = island.builder;
        RunningRows running = new RunningRows(island.data, contacts);
        island.contact(0, 1, 0);
        builder.build(0, 1);
        running.begin();
        assertThat(contacts.isAnyRunning).isFalse();
        island.contact(1, 2, 0);
        island.contact(2, 3, 0);
        island.contact(0, 2, 0);
        builder.build(0, 1);
        running.begin();
        assertThat(contacts.isAnyRunning).isTrue();
        for (int row = 0; row < contacts.count; row++) {
            int a = island.pairs.bodyA[contacts.pair[row]];
            int b = island.pairs.bodyB[contacts.pair[row]];
            assertThat(contacts.running[row]).isEqualTo(speeds[a] + speeds[b]);
            assertThat(contacts.surface[row]).isEqualTo(contacts.running[row]);
        }
    }
}
