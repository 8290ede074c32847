package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** The clock against a fake time, so that nothing here depends on how fast the machine is. */
class FrameClockTest {

    private static final long SECOND = 1_000_000_000L;
    private static final long MILLI = 1_000_000;

    /** As much as a machine that has been on for a month shows. */
    private static final long UPTIME = 30 * 24 * 3600 * SECOND;

    /** Time that passes by itself a little with every look, and by sleeping. */
    private long now = UPTIME;

    private final FrameClock clock = new FrameClock(() -> now += 1000, nanos -> now += nanos);
    private int steps;
    private int mostInATurn;

    /** Makes a turn as the loop does: input, steps, a picture, the wait. */
    private void turn(long input, long step, long picture) {
        now += input;
        int before = steps;
        do {
            steps++;
            now += step;
        } while (clock.isAnotherDueOf(FrameClock.MOST_STEPS));
        mostInATurn = Math.max(mostInATurn, steps - before);
        now += picture;
        clock.awaitTurn();
    }

    /** Makes turns for a number of seconds; returns the simulated time as a share of them. */
    private double play(double seconds, long step, long picture) {
        int before = steps;
        long start = now;
        while (now - start < seconds * SECOND) {
            turn(0, step, picture);
        }
        return (steps - before) / (double) FrameClock.RATE * SECOND / (now - start);
    }

    @Test
    void aPictureThatCostsNothingIsShownOncePerStep() {
        // The last turn begins within a look at the fake time, 1 µs, of when it is due.
        assertThat(play(10, 0, 0)).isCloseTo(1, within(1e-6));
        assertThat(mostInATurn).isEqualTo(1);
    }

    /**
     * A loop that cannot wait is called for each picture of the monitor, a little early or late.
     */
    private double playWithPicturesOf(int rate) {
        int before = steps;
        long start = now;
        for (int picture = 1; picture <= 10 * rate; picture++) {
            now = start + picture * SECOND / rate + picture % 3 * MILLI;
            if (clock.beginsTurn()) {
                do {
                    steps++;
                } while (clock.isAnotherDueOf(FrameClock.MOST_STEPS));
            }
        }
        return (steps - before) / (10.0 * FrameClock.RATE);
    }

    @Test
    void keepsTheRateForWhoIsCalledWithPicturesOfAnyMonitor() {
        for (int rate : new int[] {30, 60, 75, 144}) {
            clock.restart();
            assertThat(playWithPicturesOf(rate)).as(rate + " Hz").isCloseTo(1, within(0.005));
        }
    }

    @Test
    void keepsTheRateOnAMonitorOf144HzThatPacesEveryFrame() {
        assertThat(play(10, 0, SECOND / 144)).isCloseTo(1, within(1e-6));
        assertThat(mostInATurn).isEqualTo(1);
    }

    @Test
    void aMonitorAHairSlowerThanOursIsFollowedWithoutAJolt() {
        double share = play(60, 0, Math.round(SECOND / 59.94));
        assertThat(mostInATurn).as("two steps in a picture would be seen").isEqualTo(1);
        // A turn looks at the fake time twice, for 1 µs each: that much later is the next picture.
        assertThat(share).isCloseTo(59.94 / 60, within(2e-6 * FrameClock.RATE + 1e-5));
    }

    @Test
    void slowPicturesDoNotSlowTheWorld() {
        // The turn in which the time is up may leave up to four steps to be made in the next.
        double last = FrameClock.MOST_STEPS / (10.0 * FrameClock.RATE);
        assertThat(play(10, MILLI / 10, 60 * MILLI)).isCloseTo(1, within(last));
        assertThat(mostInATurn).isEqualTo(FrameClock.MOST_STEPS);
        assertThat(clock.pace()).as("nothing was dropped").isEqualTo(1);
    }

    @Test
    void nothingDriftsInAnHourOfSlowPictures() {
        double last = FrameClock.MOST_STEPS / (3600.0 * FrameClock.RATE);
        assertThat(play(3600, MILLI, 47 * MILLI)).isCloseTo(1, within(last));
    }

    @Test
    void picturesThatTakeLongerThanFourStepsSlowTheWorldWhichIsTold() {
        play(30, 0, 200 * MILLI);
        double share = play(30, 0, 200 * MILLI);
        assertThat(mostInATurn).isEqualTo(FrameClock.MOST_STEPS);
        // Four steps of 1/60 s every 0.2 s.
        assertThat(share).isCloseTo(1.0 / 3, within(1e-3));
        assertThat(clock.pace()).isCloseTo(1.0 / 3, within(1e-3));
    }

    @Test
    void stepsThatCannotKeepUpAreNotPiledUpInATurn() {
        play(10, 30 * MILLI, 5 * MILLI);
        mostInATurn = 0;
        double share = play(10, 30 * MILLI, 5 * MILLI);
        assertThat(mostInATurn).as("more would only put the picture off").isEqualTo(1);
        // A step of 1/60 s every 35 ms.
        assertThat(share).isCloseTo(1 / 60.0 / 0.035, within(1e-3));
        assertThat(clock.pace()).isCloseTo(1 / 60.0 / 0.035, within(1e-3));
    }

    @Test
    void aSingleLateStepIsMadeUpFor() {
        play(1, MILLI, MILLI);
        long start = now;
        int before = steps;
        turn(0, 40 * MILLI, MILLI);
        double rest = play(1, MILLI, MILLI);
        assertThat(rest).isGreaterThan(1);
        double due = (now - start) * FrameClock.RATE / (double) SECOND;
        // Where the last turn begins, its step is due and not made.
        assertThat(due - (steps - before)).isBetween(-0.01, 1.01);
    }

    /** As when garbage is collected, or another program wants the machine. */
    @Test
    void picturesThatAreUnevenlyLateDoNotSlowTheWorldEither() {
        int before = steps;
        long start = now;
        for (int i = 0; i < 100; i++) {
            turn(0, MILLI / 10, 30 * MILLI);
            // More than four steps, and less than eight.
            turn(0, MILLI / 10, 95 * MILLI);
        }
        double due = (now - start) * FrameClock.RATE / (double) SECOND;
        // Steps that the last picture postponed are not made yet.
        assertThat(due - (steps - before)).isBetween(0.0, 95 / 1000.0 * FrameClock.RATE + 1);
        // A turn that is late by less than a step is forgiven 0.5 % of one.
        assertThat(clock.pace()).isGreaterThan(0.995);
    }

    @Test
    void whatWasStoppedIsNotCaughtUpWith() {
        play(1, MILLI, MILLI);
        // A window that is dragged, a breakpoint in a step, a machine that was asleep.
        turn(5 * SECOND, MILLI, MILLI);
        turn(0, 7 * SECOND, MILLI);
        turn(0, MILLI, 3600 * SECOND);
        // Four steps follow the last halt at most; from then on all is as before.
        turn(0, MILLI, MILLI);
        mostInATurn = 0;
        assertThat(play(10, MILLI, MILLI)).isCloseTo(1, within(1e-6));
        assertThat(mostInATurn).isEqualTo(1);
        assertThat(clock.pace()).as("a halt is forgotten").isCloseTo(1, within(1e-6));
    }

    @Test
    void aNewWindowOwesNothing() {
        play(1, MILLI, MILLI);
        now += SECOND / 3;
        clock.restart();
        mostInATurn = 0;
        assertThat(play(1, MILLI, MILLI)).isCloseTo(1, within(1e-6));
        assertThat(mostInATurn).isEqualTo(1);
        assertThat(clock.pace()).isEqualTo(1);
    }

    @Test
    void whoeverActsOncePerTurnMayAskForOneStep() {
        for (int i = 0; i < 100; i++) {
            assertThat(clock.isAnotherDueOf(1)).isFalse();
            now += SECOND / 30;
            clock.awaitTurn();
        }
        // At 30 turns of one step a second; the mean of 30 turns has 100 to get there, and a drop
        // of two steps every other turn moves it by a thirtieth.
        assertThat(clock.pace()).isCloseTo(0.5, within(0.5 * Math.exp(-100 / 30.0) + 1 / 30.0));
    }
}
