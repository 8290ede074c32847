package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * Discs that fly behind a column which a wall stops. The discs are 2 m wide and move at 0.2 m/s
 * into the wall, so in half a second they are led off their paths by 0.1 m. In a column of eight,
 * an impact at its foot disturbs its end by millimetres only, since each disc gets half of the
 * reach of the one ahead.
 */
class FollowersTest {

    private static final double DT = 0.5;

    private static final int COLUMN = 8;

    /** End of the column of eight, m. */
    private static final double END = 2 * COLUMN - 1;

    private final Air air = new Air(Accuracy.GAME);

    private int disc(double x, double velocityX) {
        return air.add(
                BodyDefinition.dynamic(new Circle(1))
                        .at(x, 0)
                        .velocity(velocityX, 0)
                        .mass(1)
                        .material(new Material(1, 0, 0)));
    }

    private int piled(double x, double velocityX) {
        int slot = disc(x, velocityX);
        air.pile(slot);
        return slot;
    }

    /** Adds the column; returns its last disc. */
    private int column(double velocityX) {
        int last = 0;
        for (int i = 0; i < COLUMN; i++) {
            last = piled(2 * i, velocityX);
        }
        return last;
    }

    /** The flyer is as fast as the disc ahead of it, so only the wall makes them meet. */
    @ParameterizedTest
    @CsvSource({"0.02, true", "0.08, true", "0.12, false", "0.5, false"})
    void whatAColumnCouldBeLedIntoJoins(double gap, boolean joins) {
        air.add(Air.wall(-1, -1));
        column(-0.2);
        requireJoined(joins, disc(END + 1 + gap, -0.2));
    }

    @ParameterizedTest
    @CsvSource({"0.02, true", "0.08, true", "0.12, false", "0.5, false"})
    void andSoDoesItsMirrorImage(double gap, boolean joins) {
        air.add(Air.wall(1, 1));
        for (int i = 0; i < COLUMN; i++) {
            piled(-2 * i, 0.2);
        }
        requireJoined(joins, disc(-END - 1 - gap, 0.2));
    }

    /** A depth of a millimetre, 1/2000 of a width, is left to the next step. */
    @ParameterizedTest
    @CsvSource({"0.0018, false", "0.0022, true"})
    void whatIsLedByLittleLeavesFlyersAlone(double speed, boolean joins) {
        air.add(Air.wall(-1, -1));
        column(-speed);
        requireJoined(joins, disc(END + 1, -speed));
    }

    /** The flyer falls by 0.125 m in the step, and the column does not. */
    @ParameterizedTest
    @CsvSource({"0.2, true", "0.24, false"})
    void whatFallsIntoTheColumnJoins(double gap, boolean joins) {
        air.add(Air.wall(-1, -1));
        column(-0.2);
        int follower = disc(END + 1 + gap, -0.2);
        air.bodies.accelerationX[follower] = -1;
        requireJoined(joins, follower);
    }

    private void requireJoined(boolean joins, int follower) {
        air.fly(DT);
        assertThat(air.bodies.piled[follower]).isEqualTo(joins);
        if (joins) {
            assertThat(air.bodies.pileTime[follower]).isZero();
        }
    }

    /**
     * A disc closes by 3.9 mm on one that rests, which is led off by half of that; the sleeper
     * behind a gap g gets two thirds of what is left of it. It wakes from 1 mm on, at g = 0.45 mm;
     * 4 mm would count as an impact.
     */
    @ParameterizedTest
    @CsvSource({"0.0001, true", "0.0004, true", "0.0005, false", "0.003, false"})
    void aSleeperThatIsLedOffWakes(double gap, boolean wakes) {
        piled(0, 0.0078);
        piled(2, 0);
        int sleeper = disc(4 + gap, 0);
        int beyond = disc(6 + gap, 0);
        for (int slot : new int[] {sleeper, beyond}) {
            air.bodies.awake[slot] = false;
        }
        air.storage.data.roster.isStale = true;
        air.fly(DT);

        assertThat(air.bodies.awake[sleeper]).isEqualTo(wakes);
        assertThat(air.bodies.piled[sleeper]).isEqualTo(wakes);
    }

    /** A flyer that joins may be led into the next one. */
    @Test
    void oneFollowerBringsTheNext() {
        air.add(Air.wall(-1, -1));
        column(-0.2);
        int[] followers = new int[4];
        for (int i = 0; i < followers.length; i++) {
            followers[i] = disc(END + 1 + 0.01 + 2.01 * i, -0.2);
        }
        int last = disc(END + 1 + 0.5 + 2.01 * followers.length, -0.2);
        air.fly(DT);

        for (int follower : followers) {
            assertThat(air.bodies.piled[follower]).isTrue();
        }
        assertThat(air.bodies.piled[last]).isFalse();
    }

    @Test
    void columnThatIsNotStoppedLeadsNobodyOff() {
        column(-0.2);
        int follower = disc(END + 1.02, -0.2);
        air.fly(DT);

        assertThat(air.bodies.piled[follower]).isFalse();
    }

    /** A wall that moves at the bodies' speed does not close in on them. */
    @Test
    void frameOfReferenceDoesNotMatter() {
        air.add(
                BodyDefinition.kinematic(new Circle(1))
                        .at(-2, 0)
                        .velocity(-5, 0)
                        .material(new Material(1, 0, 0)));
        column(-5);
        int follower = disc(END + 1.02, -5);
        air.fly(DT);

        assertThat(air.bodies.piled[follower]).isFalse();
    }

    /** Two columns that close within the step get a contact, though they are 0.05 m apart. */
    @Test
    void bodiesOfPilesWithinReachGetAContact() {
        air.add(Air.wall(-1, -1));
        int last = column(-0.2);
        int behind = piled(END + 1.05, -0.2);
        air.fly(DT);

        int pair = air.pairOf(last, behind);
        assertThat(pair).isNotNegative();
        assertThat(air.pairs.points[pair]).isEqualTo(1);
    }
}
