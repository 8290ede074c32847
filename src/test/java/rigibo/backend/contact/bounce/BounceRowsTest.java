package rigibo.backend.contact.bounce;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.contact.row.StoredIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** The closing speed from which on contacts rebound, for boxes of 2 m and 1 kg on each other. */
class BounceRowsTest {

    private static final double ROUND_OFF = 1e-12;
    private static final double H = 0.01;

    private final StoredIsland island =
            new StoredIsland(Effects.of(new Contacts(), new Restitution()));
    private final PackedContacts contacts = island.contacts;
    private final RowBuilder builder = island.builder;
    private final BounceRows bounces = new BounceRows(island.data, contacts);

    private int a;
    private int b;
    private int pair;

    private int box(double y, double elasticity) {
        return island.body(
                BodyDefinition.dynamic(Polygon.box(2, 2))
                        .at(0, y)
                        .mass(1)
                        .material(new Material(1, 0, elasticity)));
    }

    @BeforeEach
    void lay() {
        int dull = box(-2, 0);
        a = box(0, 0);
        b = box(2, 0.7);
        island.contact(dull, a, Math.PI / 2);
        pair = island.contact(a, b, Math.PI / 2);
        island.point(pair, 0, 1, 0);
    }

    private double begin() {
        builder.build(0, 1);
        bounces.begin(H);
        assertThat(bounces.count).isEqualTo(1);
        int row = bounces.elastic[0];
        assertThat(contacts.pair[row]).isEqualTo(pair);
        int at = row * PackedContacts.STRIDE;
        assertThat(contacts.data[at + PackedContacts.ELASTICITY]).isEqualTo(0.7);
        assertThat(contacts.data[at + PackedContacts.BOUNCE_SPEED])
                .isEqualTo(bounces.bounceSpeeds[0]);
        return bounces.bounceSpeeds[0];
    }

    /** √(2·g·d) for a lift d of half a millimetre per metre of width, which is not visible. */
    @Test
    void reboundsThatNobodySeesAreNone() {
        island.bodies.accelerationY[b] = -10;
        assertThat(begin()).isCloseTo(Math.sqrt(2 * 10 * 0.5e-3 * 2), within(ROUND_OFF));
        // Now the lower box is pulled up.
        island.bodies.accelerationY[b] = 0;
        island.bodies.accelerationY[a] = 10;
        assertThat(begin()).isCloseTo(Math.sqrt(2 * 10 * 0.5e-3 * 2), within(ROUND_OFF));
    }

    /** A strong pull causes a higher speed within the substep; that is load. */
    @Test
    void speedByPressureIsNoImpact() {
        island.bodies.accelerationY[b] = -1000;
        assertThat(begin()).isCloseTo(1000 * H, within(ROUND_OFF));
    }

    /** The load of both points, N, times 1/mA + 1/mB. */
    @Test
    void carriedLoadPresses() {
        island.point(pair, 1, 1, 0);
        island.pairs.normalForce[2 * pair] = 300;
        island.pairs.normalForce[2 * pair + 1] = 200;
        assertThat(begin()).isCloseTo(500 * 2 * H, within(ROUND_OFF));
    }

    /**
     * A body that meets its pile within the step has moved since its contacts were measured, by
     * metres if all fly at 50 m/s.
     */
    @Test
    void placesOfBodiesDoNotMatter() {
        island.point(pair, 1, 1, 0);
        island.pairs.normalForce[2 * pair] = 300;
        double before = begin();
        island.bodies.x[a] += 3;
        island.bodies.x[b] += 5;
        assertThat(begin()).isPositive().isEqualTo(before);
    }

    /** A quarter of the speed that a pull along the surface gives counts. */
    @Test
    void pullAlongTheSurfaceCountsByAQuarter() {
        island.bodies.accelerationX[b] = 30;
        island.bodies.accelerationY[b] = 40;
        assertThat(begin()).isCloseTo(50 * H / 4, within(ROUND_OFF));
        island.bodies.accelerationX[a] = 60;
        island.bodies.accelerationY[a] = -80;
        assertThat(begin()).isCloseTo(100 * H / 4, within(ROUND_OFF));
        // Sleeping bodies are not pulled.
        island.bodies.awake[a] = false;
        assertThat(begin()).isCloseTo(50 * H / 4, within(ROUND_OFF));
    }

    @Test
    void withoutPressureAnySpeedBounces() {
        assertThat(begin()).isZero();
    }

    /** There are more contacts than the first capacity. */
    @Test
    void allElasticContactsAreListed() {
        for (int i = 0; i < 12; i++) {
            island.contact(a, b, 0.1 * i);
        }
        builder.build(0, 1);
        bounces.begin(H);
        assertThat(bounces.count).isEqualTo(13);
        for (int i = 0; i < 8; i++) {
            island.pairs.elasticity[island.contact(a, b, 0.1 * i)] = 0;
        }
        builder.build(0, 1);
        bounces.begin(H);
        assertThat(bounces.count).isEqualTo(13);
        assertThat(contacts.count).isEqualTo(22);
    }
}
