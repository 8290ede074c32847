package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.storage.Bodies;

import java.util.SplittableRandom;

/** Removal of overlap in space, for bodies two metres wide. */
class PartingLimitTest {

    private static final double WIDTH = 2;

    /** Greatest displacement of a body, in widths. */
    private static final double MOST = 0.01;

    private static final double ROUND_OFF = 1e-12;

    private final Bodies bodies = new Bodies(Effects.of(new Contacts()));
    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PartingLimit limit = new PartingLimit(bodies, motions, island.contacts);

    @BeforeEach
    void widen() {
        bodies.smallestWidth[0] = WIDTH;
    }

    @Test
    void whatIsSlowStays() {
        begin(1, 1);
        move(1, 0.9 * MOST * WIDTH, 0);
        move(2, -0.9 * MOST * WIDTH, 0);
        limit.end(MOST);
        assertThat(moved(1, Motions.DX)).isEqualTo(0.9 * MOST * WIDTH);
        assertThat(moved(2, Motions.DX)).isEqualTo(-0.9 * MOST * WIDTH);
    }

    /** Neither body is faster than the limit; turns are limited like displacements. */
    @Test
    void whatIsFastIsHeldBack() {
        begin(1, 1);
        move(1, 0, 4 * MOST * WIDTH);
        move(2, 0, -4 * MOST * WIDTH);
        motions.data[Motions.STRIDE + Motions.TURN] = 0.4;
        limit.end(MOST);
        assertThat(moved(1, Motions.DY)).isCloseTo(MOST * WIDTH, within(ROUND_OFF));
        assertThat(moved(2, Motions.DY)).isCloseTo(-MOST * WIDTH, within(ROUND_OFF));
        assertThat(moved(1, Motions.TURN)).isCloseTo(0.1, within(ROUND_OFF));
    }

    /** With any masses the centre stays where recovery left it; only momenta move it. */
    @Test
    void centreOfMassStays() {
        SplittableRandom random = new SplittableRandom(5);
        int heldBack = 0;
        for (int i = 0; i < 1_000; i++) {
            double[] inverseMass = random.doubles(random.nextInt(2, 12), 0.1, 10).toArray();
            begin(inverseMass);
            double x = 0;
            double mass = 0;
            for (int entry = 1; entry <= inverseMass.length; entry++) {
                move(entry, random.nextDouble(-0.1, 0.1), random.nextDouble(-0.1, 0.1));
                x += moved(entry, Motions.DX) / inverseMass[entry - 1];
                mass += 1 / inverseMass[entry - 1];
            }
            // Recovery pushes pairs apart and leaves the centre in place.
            motions.moveAll(-x / mass, 0);
            double fastest = fastest(inverseMass.length);
            limit.end(MOST);
            double left = 0;
            for (int entry = 1; entry <= inverseMass.length; entry++) {
                left += moved(entry, Motions.DX) / inverseMass[entry - 1];
            }
            assertThat(left / mass).isCloseTo(0, within(ROUND_OFF));
            assertThat(fastest(inverseMass.length)).isLessThan(MOST * WIDTH + ROUND_OFF);
            heldBack += fastest > MOST * WIDTH ? 1 : 0;
        }
        assertThat(heldBack).isGreaterThan(900);
    }

    /** Pushes up and down must not be limited, or the ground would lift the bodies. */
    @Test
    void nothingIsHeldBackOnTheGround() {
        begin(1, 1);
        island.onGround(1, 0.5, 0.5);
        limit.begin();
        move(1, 0, 1);
        move(2, 0, -1);
        limit.end(MOST);
        assertThat(moved(1, Motions.DY)).isEqualTo(1);
        assertThat(moved(2, Motions.DY)).isEqualTo(-1);
    }

    private void begin(double... inverseMass) {
        island.begin(inverseMass.length);
        for (int entry = 1; entry <= inverseMass.length; entry++) {
            island.body(entry, inverseMass[entry - 1], 0);
        }
        limit.begin();
    }

    private void move(int entry, double x, double y) {
        motions.data[entry * Motions.STRIDE + Motions.DX] = x;
        motions.data[entry * Motions.STRIDE + Motions.DY] = y;
    }

    private double moved(int entry, int column) {
        return motions.data[entry * Motions.STRIDE + column];
    }

    private double fastest(int count) {
        double most = 0;
        for (int entry = 1; entry <= count; entry++) {
            double way = Math.hypot(moved(entry, Motions.DX), moved(entry, Motions.DY));
            most = Math.max(most, way);
        }
        return most;
    }
}
