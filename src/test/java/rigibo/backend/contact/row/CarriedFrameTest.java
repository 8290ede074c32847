package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/** Two boxes on carriers that move with (3, −2) m/s. */
class CarriedFrameTest {

    private static final double ROUND_OFF = 1e-15;

    private final StoredIsland island = StoredIsland.turning();
    private final Motions motions = island.motions;
    private final CarriedFrame frame = new CarriedFrame(island.data, motions);
    private final int one = box(0);
    private final int other = box(1);

    private int box(double x) {
        return island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(x, 0).velocity(5, 7));
    }

    private int carrier(double x, double vx, double vy, double spin) {
        return island.body(
                BodyDefinition.kinematic(Polygon.box(1, 1)).at(x, -1).velocity(vx, vy).spin(spin));
    }

    /** In the frame carriers stand still, and places are those of the step's start. */
    @Test
    void islandIsSolvedWhereItsCarriersStandStill() {
        int left = carrier(0, 3, -2, 0);
        int right = carrier(1, 3, -2, 0);
        island.contact(one, left, 0);
        island.contact(one, other, 0);
        island.contact(right, other, 0);
        island.bodies.pileTime[other] = 0.1;
        frame.enter(0);
        assertThat(motions.frameX).isEqualTo(3);
        assertThat(motions.frameY).isEqualTo(-2);
        for (int slot : new int[] {left, right}) {
            assertThat(island.bodies.velocityX[slot]).isZero();
            assertThat(island.bodies.velocityY[slot]).isZero();
        }
        for (int slot : new int[] {one, other}) {
            assertThat(island.bodies.velocityX[slot]).isEqualTo(2);
            assertThat(island.bodies.velocityY[slot]).isEqualTo(9);
        }
        assertThat(island.bodies.x[one]).isZero();
        assertThat(island.bodies.x[other]).isCloseTo(1 - 0.3, within(ROUND_OFF));
        assertThat(island.bodies.y[other]).isCloseTo(0.2, within(ROUND_OFF));
        frame.leave(0, 0.25);
        assertThat(motions.isInWorld()).isTrue();
        for (int slot : new int[] {left, right}) {
            assertThat(island.bodies.velocityX[slot]).isEqualTo(3);
            assertThat(island.bodies.velocityY[slot]).isEqualTo(-2);
        }
        assertThat(island.bodies.velocityX[other]).isEqualTo(5);
        assertThat(island.bodies.velocityY[other]).isEqualTo(7);
        assertThat(island.bodies.x[one]).isEqualTo(0.75);
        assertThat(island.bodies.y[one]).isEqualTo(-0.5);
        assertThat(island.bodies.x[other]).isCloseTo(1 - 0.3 + 0.75, within(ROUND_OFF));
        assertThat(island.bodies.y[other]).isCloseTo(0.2 - 0.5, within(ROUND_OFF));
    }

    /** If the carriers differ in any component, or if one turns or stands still. */
    @ParameterizedTest
    @CsvSource({"3, -1, 0", "2, -2, 0", "3, -2, 1", "0, 0, 0", "0, 0, 2"})
    void worldIsKeptIfCarriersDiffer(double vx, double vy, double spin) {
        int left = carrier(0, 3, -2, 0);
        int right = carrier(1, vx, vy, spin);
        island.contact(one, left, 0);
        island.contact(other, right, 0);
        assertWorldIsKept();
    }

    private void assertWorldIsKept() {
        double velocity = island.bodies.velocityX[one];
        frame.enter(0);
        assertThat(motions.isInWorld()).isTrue();
        assertThat(island.bodies.velocityX[one]).isEqualTo(velocity);
        frame.leave(0, 1);
        assertThat(island.bodies.velocityX[one]).isEqualTo(velocity);
        assertThat(island.bodies.x[one]).isZero();
    }

    @Test
    void worldIsKeptOnFixedBodies() {
        int floor = island.body(BodyDefinition.fixed(Polygon.box(1, 1)).at(0, -1));
        island.contact(one, floor, 0);
        assertWorldIsKept();
    }

    @Test
    void worldIsKeptWithoutCarriers() {
        island.contact(one, other, 0);
        assertWorldIsKept();
    }

    /** Listed for several contacts, a carrier is one; two bodies are two. */
    @Test
    void carrierMayCarryMoreThanOnce() {
        int left = carrier(0, 3, -2, 0);
        int right = carrier(1, 3, -2, 0);
        island.contact(one, left, 0);
        island.contact(other, left, 0);
        island.contact(other, right, 0);
        island.contact(one, left, 1);
        frame.enter(0);
        assertThat(motions.frameX).isEqualTo(3);
        frame.leave(0, 0);
        assertThat(island.bodies.velocityX[left]).isEqualTo(3);
        assertThat(island.bodies.velocityX[right]).isEqualTo(3);
        assertThat(island.bodies.velocityX[one]).isEqualTo(5);
    }

    /** A body locked in an axis cannot move along with a carrier in that axis. */
    @ParameterizedTest
    @CsvSource({"true, 3, 0, false", "true, 0, 3, true", "false, 0, 3, false", "false, 3, 0, true"})
    void bodiesWithLockedAxesStayInTheWorld(boolean inX, double vx, double vy, boolean follows) {
        BodyDefinition held = BodyDefinition.dynamic(Polygon.box(1, 1)).at(2, 0);
        int locked = island.body(inX ? held.lockX() : held.lockY());
        int left = carrier(0, vx, vy, 0);
        island.contact(one, left, 0);
        island.contact(locked, left, 0);
        frame.enter(0);
        assertThat(motions.isInWorld()).isEqualTo(!follows);
    }
}
