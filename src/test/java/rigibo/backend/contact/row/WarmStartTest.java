package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/** Kicks that begin with the impulses of the last one, for random contacts. */
class WarmStartTest {

    private static final double ROUND_OFF = 1e-13;
    private static final int COUNT = 6;

    private final PackedIsland island = new PackedIsland();
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final WarmStart warmStart = new WarmStart(island.motions, contacts);

    private void begin(SplittableRandom random) {
        island.bodies(random, COUNT);
        for (int entry = 1; entry <= COUNT; entry++) {
            int row = island.contact(random, entry - 1, entry);
            island.set(row, PackedContacts.IMPULSE0, random.nextDouble());
            island.set(row, PackedContacts.IMPULSE1, random.nextDouble());
            island.set(row, PackedContacts.IMPULSE_T, random.nextDouble(-1, 1));
            island.set(row, PackedContacts.IMPULSE_R, random.nextDouble(-1, 1));
        }
    }

    /** M⁻¹·Jᵀ times the impulses, scaled by the lengths of both kicks. */
    @Test
    void impulsesAreScaledAndApplied() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 50; i++) {
            begin(random);
            double[] before = dense.velocities();
            double[] impulses = dense.impulses();
            warmStart.apply(0.5, 0);
            for (int k = 0; k < impulses.length; k++) {
                impulses[k] /= 2;
            }
            assertThat(dense.impulses()).isEqualTo(impulses);
            double[] change = dense.change(impulses);
            for (int k = 3; k < before.length; k++) {
                assertThat(dense.velocities()[k])
                        .isCloseTo(before[k] + change[k], within(ROUND_OFF));
            }
            warmStart.add(-1, 0);
            for (int k = 3; k < before.length; k++) {
                assertThat(dense.velocities()[k]).isCloseTo(before[k], within(ROUND_OFF));
            }
            assertThat(dense.impulses()).isEqualTo(impulses);
        }
    }

    /** Without rotation nothing turns, whatever the levers are. */
    @Test
    void nothingTurnsWithoutRotation() {
        SplittableRandom random = new SplittableRandom(2);
        begin(random);
        Motions still = new Motions(false);
        still.count = island.motions.count;
        still.data = island.motions.data.clone();
        new WarmStart(still, contacts).add(1, 0);
        double[] change = dense.change(dense.impulses());
        for (int i = 3; i < change.length; i++) {
            int at = i / 3 * Motions.STRIDE + i % 3;
            double truth = island.motions.data[at] + (i % 3 == 2 ? 0 : change[i]);
            assertThat(still.data[at]).isCloseTo(truth, within(ROUND_OFF));
        }
    }

    /** A body that joins in substep 2 takes part from then on. */
    @Test
    void whatJoinsLaterIsLeftOut() {
        SplittableRandom random = new SplittableRandom(3);
        begin(random);
        contacts.firstSubstep[1] = 2;
        island.set(1, PackedContacts.BEFORE0, 3);
        island.set(1, PackedContacts.BEFORE1, 5);
        double[] impulses = dense.impulses();
        double[] before = dense.velocities();
        warmStart.apply(2, 1);
        warmStart.scaleBefore(2, 1);
        double[] applied = new double[impulses.length];
        for (int k = 0; k < impulses.length; k++) {
            applied[k] = k / DenseRows.KINDS == 1 ? 0 : 2 * impulses[k];
        }
        assertThat(island.of(1, PackedContacts.IMPULSE0)).isEqualTo(impulses[DenseRows.KINDS]);
        assertThat(island.of(1, PackedContacts.BEFORE0)).isEqualTo(3);
        double[] change = dense.change(applied);
        for (int k = 3; k < before.length; k++) {
            assertThat(dense.velocities()[k]).isCloseTo(before[k] + change[k], within(ROUND_OFF));
        }
        warmStart.scaleBefore(2, 2);
        assertThat(island.of(1, PackedContacts.BEFORE0)).isEqualTo(6);
        assertThat(island.of(1, PackedContacts.BEFORE1)).isEqualTo(10);
    }

    /** No impulse grows, and impulses taken back no longer move the bodies. */
    @Test
    void whatPartsIsTakenBack() {
        SplittableRandom random = new SplittableRandom(6);
        int taken = 0;
        for (int i = 0; i < 200; i++) {
            begin(random);
            double[] impulses = dense.impulses();
            double[] before = dense.velocities();
            warmStart.takeBackWhatParts(0, 1 + i % 3);
            double[] left = dense.impulses();
            double[] less = new double[left.length];
            for (int k = 0; k < left.length; k++) {
                assertThat(Math.abs(left[k])).isLessThanOrEqualTo(Math.abs(impulses[k]));
                less[k] = left[k] - impulses[k];
                taken += less[k] == 0 ? 0 : 1;
            }
            double[] change = dense.change(less);
            for (int k = 3; k < before.length; k++) {
                assertThat(dense.velocities()[k])
                        .isCloseTo(before[k] + change[k], within(ROUND_OFF));
            }
        }
        assertThat(taken).isGreaterThan(200);
    }

    /** A body of 2 kg that a load of 3 N·s drives up at 1 m/s keeps 1 N·s of it and stands. */
    @Test
    void whatStandsOnAContactKeepsItsLoad() {
        island.begin(1);
        island.body(1, 0.5, 0);
        int row = island.onGround(1, 0, 0);
        int at = Motions.STRIDE;
        island.motions.data[at + Motions.VX] = 0;
        island.motions.data[at + Motions.VY] = 0;
        double nx = island.of(row, PackedContacts.NX);
        double ny = island.of(row, PackedContacts.NY);
        island.set(row, PackedContacts.IMPULSE0, 3);
        double speed = 1;
        island.motions.data[at + Motions.VX] = speed * nx;
        island.motions.data[at + Motions.VY] = speed * ny;
        warmStart.takeBackWhatParts(0, 1);
        assertThat(island.motions.parting(contacts, row, 0)).isCloseTo(0, within(ROUND_OFF));
        assertThat(island.of(row, PackedContacts.IMPULSE0)).isCloseTo(1, within(ROUND_OFF));
    }

    /** A load is kept; an impact, which the last kick did not have, starts from zero. */
    @Test
    void impactsAreLeftOutAndLoadsStay() {
        SplittableRandom random = new SplittableRandom(4);
        begin(random);
        island.set(0, PackedContacts.BEFORE0, 2);
        island.set(0, PackedContacts.BEFORE1, 2);
        island.set(1, PackedContacts.BEFORE0, 0);
        island.set(1, PackedContacts.BEFORE1, 0);
        island.set(2, PackedContacts.IMPULSE0, 4);
        island.set(2, PackedContacts.IMPULSE1, 1);
        island.set(2, PackedContacts.IMPULSE_T, 3);
        island.set(2, PackedContacts.IMPULSE_R, -2);
        island.set(2, PackedContacts.BEFORE0, 1);
        island.set(2, PackedContacts.BEFORE1, 9);
        island.set(3, PackedContacts.IMPULSE0, 0);
        island.set(3, PackedContacts.IMPULSE1, 0);
        double[] impulses = dense.impulses();
        warmStart.leaveOutImpacts(1.5);
        for (int kind = 0; kind < DenseRows.KINDS; kind++) {
            assertThat(dense.impulses()[kind]).isEqualTo(impulses[kind]);
            assertThat(dense.impulses()[DenseRows.KINDS + kind]).isZero();
        }
        // One and a half times 1, all of 1, and half of the rest: (1.5 + 1)/(4 + 1).
        assertThat(island.of(2, PackedContacts.IMPULSE0)).isEqualTo(1.5);
        assertThat(island.of(2, PackedContacts.IMPULSE1)).isEqualTo(1);
        assertThat(island.of(2, PackedContacts.IMPULSE_T)).isEqualTo(1.5);
        assertThat(island.of(2, PackedContacts.IMPULSE_R)).isEqualTo(-1);
        // The record of the last kick now holds this one, unchanged.
        assertThat(island.of(2, PackedContacts.BEFORE0)).isEqualTo(4);
        assertThat(island.of(2, PackedContacts.BEFORE1)).isEqualTo(1);
        // A contact without a load has no friction, either.
        assertThat(island.of(3, PackedContacts.IMPULSE_T)).isZero();
    }

    @Test
    void aStepBeginsWithTwoEqualKicks() {
        begin(new SplittableRandom(5));
        warmStart.prepare();
        for (int row = 0; row < COUNT; row++) {
            assertThat(island.of(row, PackedContacts.BEFORE0))
                    .isEqualTo(island.of(row, PackedContacts.IMPULSE0));
            assertThat(island.of(row, PackedContacts.BEFORE1))
                    .isEqualTo(island.of(row, PackedContacts.IMPULSE1));
        }
    }
}
