package rigibo.backend.contact.bounce;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.effect.Effects;
import rigibo.backend.storage.Bodies;

import java.util.SplittableRandom;

/** Shifts by impacts are kept as long as they lead into no other body. */
class ImpactShiftsTest {

    private static final double ROUND_OFF = 1e-12;

    /** Overlap that is not visible, as a share of the width, which is 1 m here. */
    private static final double UNSEEN = 1e-4;

    /** Gap up to which bodies touch, as a share of the width. */
    private static final double TOUCHED = 1e-8;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final Bodies bodies = new Bodies(Effects.of());
    private final ImpactShifts shifts = new ImpactShifts(bodies, motions, island.contacts);

    @Test
    void shiftThatLeadsIntoNothingStays() {
        tower(1, 0.5);
        shifts.begin();
        shift(1, -0.4);
        shifts.limit(0);
        assertThat(way(1)).isEqualTo(-0.4);
    }

    /** Of the shift only the gap is left, and the overlap that is not visible. */
    @Test
    void shiftEndsAtTheGround() {
        tower(1, 0.1);
        shifts.begin();
        shift(1, -0.3);
        shifts.limit(0);
        assertThat(way(1)).isCloseTo(-0.1 - UNSEEN, within(ROUND_OFF));
    }

    /** Former overlap does not hold back a shift apart. */
    @Test
    void shiftOutOfAnOverlapStays() {
        tower(1, -0.1);
        shifts.begin();
        shift(1, 0.05);
        shifts.limit(0);
        assertThat(way(1)).isEqualTo(0.05);
    }

    /** 1 kg under 10 m/s² is lifted by the energy that the impacts lost: 0.05 m for ½ J. */
    @Test
    void impactsPayForWhatIsLifted() {
        bodies.accelerationY[0] = -10;
        tower(1, 0.1);
        shifts.begin();
        shift(1, -0.3);
        shifts.take(0.5);
        shifts.limit(0);
        assertThat(way(1)).isCloseTo(-0.3 + 0.05, within(ROUND_OFF));
    }

    /** The gain from a driven surface in an impact neither pays for a lift nor costs anything. */
    @Test
    void gainOfAImpactDoesNotCount() {
        bodies.accelerationY[0] = -10;
        tower(1, 0.1);
        shifts.begin();
        shift(1, -0.3);
        shifts.take(-1);
        shifts.take(0.5);
        shifts.limit(0);
        assertThat(way(1)).isCloseTo(-0.3 + 0.05, within(ROUND_OFF));
    }

    /** A contact that joins later does not hold yet. */
    @Test
    void contactThatIsNotThereYetHoldsNothingBack() {
        tower(1, 0.1);
        island.contacts.firstSubstep[0] = 2;
        shifts.begin();
        shift(1, -0.3);
        shifts.limit(1);
        assertThat(way(1)).isEqualTo(-0.3);
        shifts.limit(2);
        assertThat(way(1)).isCloseTo(-0.1 - UNSEEN, within(ROUND_OFF));
    }

    /** A body on the ground stays in place when others are struck. */
    @Test
    void whatTouchesIsNotShiftedIntoTheGround() {
        tower(1, 0);
        shifts.begin();
        shift(1, -0.01);
        shifts.limitOfTouching(0, TOUCHED, 0.01, TOUCHED);
        assertThat(way(1)).isCloseTo(-TOUCHED, within(ROUND_OFF));
    }

    /** At 3 m/s upwards the body is 2 cm above the ground after a hundredth of a second. */
    @Test
    void whatPartsInTimeKeepsItsShift() {
        tower(1, 0);
        motions.data[Motions.STRIDE + Motions.VY] = 3;
        shifts.begin();
        shift(1, -0.01);
        shifts.limitOfTouching(0, TOUCHED, 0.01, TOUCHED);
        assertThat(way(1)).isEqualTo(-0.01);
    }

    /** A falling body meets the ground at the end of its gap, not at its present place. */
    @Test
    void whatHasAGapKeepsItsShift() {
        tower(1, 0.05);
        shifts.begin();
        shift(1, -0.06);
        shifts.limitOfTouching(0, TOUCHED, 0.01, TOUCHED);
        assertThat(way(1)).isEqualTo(-0.06);
    }

    /** Turning brings a corner down by its lever. */
    @Test
    void turnEndsAtTheGround() {
        island.begin(1);
        island.body(1, 1, 1);
        int row = island.onGround(1, 0.5, 0.5);
        island.contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0] = 0.1;
        island.contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP1] = 0.1;
        shifts.begin();
        shifts.shift(Motions.STRIDE, 0, 0, 0.4);
        shifts.limit(0);
        double turn = motions.data[Motions.STRIDE + Motions.TURN];
        assertThat(0.5 * turn).isCloseTo(0.1 + UNSEEN, within(ROUND_OFF));
    }

    /**
     * A body that is held back holds back the one behind it. None of a tower, shifted at any place,
     * gets farther into the one below than it was, except for overlap that is not visible.
     */
    @Test
    void nobodyOfATowerIsShiftedIntoAnother() {
        SplittableRandom random = new SplittableRandom(3);
        int heldBack = 0;
        int kept = 0;
        for (int i = 0; i < 2_000; i++) {
            int count = random.nextInt(1, 8);
            tower(count, random.nextDouble(0, 0.1));
            shifts.begin();
            double[] wanted = new double[count + 1];
            for (int body = 1; body <= count; body++) {
                wanted[body] = random.nextDouble(-0.2, 0.1);
                shift(body, wanted[body]);
            }
            shifts.limit(0);
            for (int body = 1; body <= count; body++) {
                double gap = motions.gap(island.contacts, body - 1, 0);
                assertThat(gap).isGreaterThan(-UNSEEN - ROUND_OFF);
                assertThat(Math.abs(way(body))).isLessThanOrEqualTo(Math.abs(wanted[body]));
                heldBack += way(body) == wanted[body] ? 0 : 1;
                kept += way(body) == wanted[body] ? 1 : 0;
            }
            for (int column = 0; column < Motions.STRIDE; column++) {
                assertThat(motions.data[column]).isZero();
            }
        }
        assertThat(heldBack).isGreaterThan(1_000);
        assertThat(kept).isGreaterThan(1_000);
    }

    /** A tower of bodies that do not turn, with a gap below each, m. */
    private void tower(int count, double gap) {
        island.begin(count);
        for (int body = 1; body <= count; body++) {
            island.body(body, 1, 0);
        }
        for (int body = 1; body <= count; body++) {
            int row = island.contact(body - 1, body, 0.5, 0.5);
            island.contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0] = gap;
        }
    }

    private void shift(int entry, double y) {
        shifts.shift(entry * Motions.STRIDE, 0, y, 0);
    }

    private double way(int entry) {
        return motions.data[entry * Motions.STRIDE + Motions.DY];
    }
}
