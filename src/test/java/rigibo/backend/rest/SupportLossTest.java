package rigibo.backend.rest;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

/** How much work it is to find out who wakes when a body goes: contacts looked at are counted. */
class SupportLossTest {

    private static final double GRAVITY = 9.81;

    /**
     * A body's contacts are looked at once for what it stands on and what stands on it, and once
     * for whom to ask next; each contact has two bodies. One round more for waking, one for the
     * start.
     */
    private static final int LOOKS_PER_CONTACT = 8;

    private final DataStorage data =
            new DataStorage(
                    Effects.of(
                            new Gravity(0, -GRAVITY), new Contacts(), new Rotation(), new Sleep()));
    private final Bodies bodies = data.bodies;
    private final Pairs pairs = data.pairs;
    private final SupportLoss loss = new SupportLoss(data, new Waking(data));

    private final int floor = body(BodyType.STATIC, 0, -1);

    private int sleeper(double x, double y) {
        return body(BodyType.DYNAMIC, x, y);
    }

    private int body(BodyType type, double x, double y) {
        int slot = bodies.take();
        bodies.type[slot] = type;
        bodies.x[slot] = x;
        bodies.y[slot] = y;
        bodies.smallestWidth[slot] = 1;
        bodies.accelerationY[slot] = -GRAVITY;
        bodies.firstPair[slot] = Pairs.NONE;
        return slot;
    }

    /** Lets a body stand on another between two places, m. */
    private void stand(int upper, int lower, double left, double right) {
        int pair = pairs.add(bodies, Math.min(upper, lower), Math.max(upper, lower));
        pairs.normalY[pair] = upper < lower ? -1 : 1;
        pairs.points[pair] = 2;
        pairs.touching[pair] = true;
        pairs.pointX[2 * pair] = left;
        pairs.pointX[2 * pair + 1] = right;
    }

    /** Boxes of 1 m that stand on two each; returns the one at the top. */
    private int pyramid(int storeys) {
        int[] below = new int[storeys];
        for (int storey = 0; storey < storeys; storey++) {
            int[] here = new int[storeys - storey];
            for (int i = 0; i < here.length; i++) {
                double x = i + storey / 2.0;
                here[i] = sleeper(x, storey);
                if (storey == 0) {
                    stand(here[i], floor, x - 0.5, x + 0.5);
                } else {
                    stand(here[i], below[i], x - 0.5, x);
                    stand(here[i], below[i + 1], x, x + 0.5);
                }
            }
            below = here;
        }
        return below[0];
    }

    private int tower(int storeys) {
        int top = sleeper(0, 0);
        stand(top, floor, -0.5, 0.5);
        for (int storey = 1; storey < storeys; storey++) {
            int next = sleeper(0, storey);
            stand(next, top, -0.5, 0.5);
            top = next;
        }
        return top;
    }

    private void requireLinearWork() {
        assertThat(loss.contactsLookedAt())
                .isLessThanOrEqualTo((long) LOOKS_PER_CONTACT * pairs.slots.inUse());
    }

    private boolean isAnyAwakeBut(int one) {
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (slot != one && bodies.awake[slot]) {
                return true;
            }
        }
        return false;
    }

    /**
     * The one contact of what goes; then those of each storey below it, twice: for what it stands
     * on and carries, and for whom to ask next. Each has two, but the ground nobody asks.
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 10})
    void aTowerIsLookedAtTwiceAStorey(int storeys) {
        loss.wakeNeighbours(tower(storeys));
        assertThat(loss.contactsLookedAt()).isEqualTo(1 + 2 * 2 * (storeys - 1L));
    }

    /**
     * Nobody is asked what to do without a floor; waking looks at every contact from both sides.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 10})
    void aTowerThatLosesTheFloorIsOnlyWoken(int storeys) {
        tower(storeys);
        loss.wakeNeighbours(floor);
        assertThat(loss.contactsLookedAt()).isEqualTo(1 + 2L * (storeys - 1) + 1);
    }

    /** Followed along every way down, the supports of 100 storeys would be 2¹⁰⁰. */
    @Test
    void aPyramidThatLosesItsTopIsLookedAtOnce() {
        int top = pyramid(100);
        loss.wakeNeighbours(top);
        assertThat(isAnyAwakeBut(top)).isFalse();
        requireLinearWork();
    }

    /** Asked by a call for each storey, this would be out of stack. */
    @Test
    void aTowerOfAHundredThousandKeepsStandingWithoutItsTop() {
        int top = tower(100_000);
        loss.wakeNeighbours(top);
        assertThat(isAnyAwakeBut(top)).isFalse();
        requireLinearWork();
    }

    @Test
    void aPyramidThatLosesTheFloorWakesAtOnce() {
        int top = pyramid(40);
        loss.wakeNeighbours(floor);
        assertThat(bodies.awake[top]).isTrue();
        requireLinearWork();
    }

    /**
     * A row of boxes on one plank, each in touch with the next: every one of them finds the plank.
     */
    @Test
    void aPlankUnderARowOfBoxesIsSpreadFromOnce() {
        int plank = sleeper(0, 0);
        int before = sleeper(0, 1);
        stand(before, plank, -0.5, 0.5);
        for (int i = 1; i < 2000; i++) {
            int box = sleeper(i, 1);
            stand(box, plank, i - 0.5, i + 0.5);
            int side = pairs.add(bodies, before, box);
            pairs.normalX[side] = 1;
            pairs.touching[side] = true;
            before = box;
        }
        int hung = sleeper(0, -1);
        stand(plank, hung, -0.5, 0.5);
        loss.wakeNeighbours(hung);
        assertThat(bodies.awake[before]).isTrue();
        requireLinearWork();
    }

    /** A box carried by one that is pulled upwards, whose support the box is in its turn. */
    @Test
    void supportsInACircleAreNotSteady() {
        int riser = sleeper(0, 0);
        bodies.accelerationY[riser] = GRAVITY;
        int middle = sleeper(0, 1);
        int top = sleeper(0, 2);
        stand(middle, riser, -0.5, 0.5);
        stand(top, middle, -0.5, 0.5);
        loss.wakeNeighbours(top);
        assertThat(bodies.awake[middle]).isTrue();
        assertThat(bodies.awake[riser]).isTrue();
    }
}
