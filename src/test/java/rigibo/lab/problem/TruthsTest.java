package rigibo.lab.problem;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.lab.truth.Bounces;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Room;

/** Formulas of the problems against the same mechanics in very small steps. */
class TruthsTest {

    /** s; errors of Euler's method shrink with it. */
    private static final double TINY = 1e-6;

    @ParameterizedTest
    @CsvSource({"20, 15, 1", "20, 33, 3", "12, 25, 3", "33, 12, 2"})
    void throwAgainstAirSlowsAsItsDragSays(double terminal, double thrown, double time) {
        double v = thrown;
        for (int i = 0; i < Math.round(time / TINY); i++) {
            v -= TINY * Earth.GRAVITY * (1 + v * Math.abs(v) / (terminal * terminal));
        }
        assertThat(Drags.quadratic(terminal, thrown, time)).isCloseTo(v, within(1e-4));
    }

    /** Friction of 0.5·g on a disc's centre and, twice that, on its rim, until they are equal. */
    @ParameterizedTest
    @CsvSource({"5.03, 2", "9.29, 2", "7, 0.6"})
    void slippingDiscEndsUpRolling(double speed, double time) {
        double braking = 0.5 * Earth.GRAVITY;
        double v = speed;
        double rim = 0;
        double way = 0;
        for (int i = 0; i < Math.round(time / TINY); i++) {
            if (v > rim) {
                v -= TINY * braking;
                rim += TINY * 2 * braking;
            }
            way += TINY * v;
        }
        assertThat(SlideAndRoll.rolling(speed, time)).isCloseTo(way, within(1e-4));
        assertThat(v).isCloseTo(2 * speed / 3, within(1e-4));
    }

    @Test
    void slidingBoxesLoseTheirEnergyToFriction() {
        double work = 0.5 * Earth.GRAVITY * SlideAndRoll.stopping(8);
        assertThat(work).isCloseTo(8 * 8 / 2.0, within(1e-12));
        double way = SlideAndRoll.downhill(2);
        double slope = Math.atan(0.5) + Math.toRadians(10);
        double left = Earth.GRAVITY * way * (Math.sin(slope) - 0.5 * Math.cos(slope));
        double speed = 2 * way / 2;
        assertThat(left).isCloseTo(speed * speed / 2, within(1e-12));
    }

    /** The equations that the formulas were got from: Newton's for each body, and no slip. */
    @Test
    void pulledBoxAndItsDiscsBalance() {
        double box = PulledBox.BOX_GAINS;
        double disc = PulledBox.DISC_GAINS;
        double ground = 0.4 * (10 + 25) * Earth.GRAVITY;
        assertThat(150 - ground).isCloseTo(10 * box + 25 * disc, within(1e-12));
        double rim = disc + 2 * disc;
        assertThat(rim).isCloseTo(box, within(1e-12));
        assertThat(disc).isLessThan(0.8 * Earth.GRAVITY);
    }

    @Test
    void discInARoomIsReflectedAtEachWall() {
        Room room = new Room(50, 38);
        double x = 4;
        double y = 3;
        double vx = 50;
        double vy = 38;
        int bounces = 0;
        double step = 1e-5;
        for (int i = 1; i <= 100_000; i++) {
            x += vx * step;
            y += vy * step;
            if (x < 0.25 || x > 9.75) {
                x = 2 * (x < 0.25 ? 0.25 : 9.75) - x;
                vx = -vx;
                bounces++;
            }
            if (y < 0.25 || y > 7.75) {
                y = 2 * (y < 0.25 ? 0.25 : 7.75) - y;
                vy = -vy;
                bounces++;
            }
            assertThat(room.off(x, y, i * step)).isLessThan(1e-9);
        }
        assertThat((double) bounces).isCloseTo(room.bouncesPerSecond(), within(2.0));
        assertThat(room.off(x + 0.1, y, 1)).isCloseTo(0.01, within(1e-9));
    }

    /** Seen in steps of any length, phase or beginning, a true flight shows no error. */
    @ParameterizedTest
    @CsvSource({"0.0166, 0", "0.0333, 0", "0.005, 0.003"})
    void trueBouncesAreSeenWithoutError(double step, double begin) {
        Rebounds.Rebound seen = new Rebounds.Rebound(new Bounces(2, 0.8));
        watch(seen, step, begin, 0.8);
        assertThat(seen.seen).isEqualTo(5);
        assertThat(seen.apex).isLessThan(1e-12);
        assertThat(seen.landing).isLessThan(1e-12);
    }

    @Test
    void bouncesOfAnotherElasticityAreSeenAsErrors() {
        Rebounds.Rebound seen = new Rebounds.Rebound(new Bounces(2, 0.8));
        watch(seen, 1.0 / 60, 0, 0.79);
        assertThat(seen.apex).isCloseTo(0.64 - 0.79 * 0.79, within(5e-3)).isGreaterThan(0.0158);
        assertThat(seen.landing).isGreaterThan(0.01);
    }

    private static void watch(Rebounds.Rebound seen, double step, double begin, double e) {
        Bounces flight = new Bounces(2, e);
        for (double time = begin; time < flight.impactTime(6); time += step) {
            int n = 0;
            while (flight.impactTime(n + 1) <= time) {
                n++;
            }
            double top = (flight.impactTime(n + 1) + (n == 0 ? 0 : flight.impactTime(n))) / 2;
            double since = time - (n == 0 ? 0 : top);
            double above = flight.apex(n) - Earth.GRAVITY * since * since / 2;
            seen.see(time, above, -Earth.GRAVITY * since);
        }
    }
}
