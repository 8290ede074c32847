package rigibo.backend.collision.manifold;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Capsule;

import java.util.SplittableRandom;

/**
 * Two capsules one behind the other, nearly in one line. Their gap is the distance of the round
 * ends: if these differ by (d, y), it is √(d² + y²) − 2r, whatever the tilt of the lines.
 */
class CapsulesInLineTest {

    private static final double RADIUS = 0.12;
    private static final double HALF = 0.12;

    /** Round-off of places of a metre. */
    private static final double ROUND_OFF = 1e-14;

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
    void theGapIsThatOfTheEnds(double off) {
        SplittableRandom random = new SplittableRandom(4);
        Capsule capsule = new Capsule(HALF, RADIUS);
        for (int i = 0; i < 2_000; i++) {
            double turn = 6 * random.nextDouble();
            double tilt = off * (2 * random.nextDouble() - 1);
            double apart = 0.2 + 0.2 * random.nextDouble();
            double aside = off * (2 * random.nextDouble() - 1);
            // The end of A is the origin; B's near end is at (apart, aside), before all is rotated.
            double x = apart + HALF * Math.cos(tilt);
            double y = aside + HALF * Math.sin(tilt);
            double cos = Math.cos(turn);
            double sin = Math.sin(turn);
            Meeting meeting =
                    new Meeting(
                            capsule,
                            Meeting.pose(-HALF * cos, -HALF * sin, turn),
                            capsule,
                            Meeting.pose(cos * x - sin * y, sin * x + cos * y, turn + tilt));
            double gap = Math.sqrt(apart * apart + aside * aside) - 2 * RADIUS;
            for (Meeting either : new Meeting[] {meeting, meeting.exchanged()}) {
                assertThat(either.within(1).count).as("draw %d", i).isPositive();
                assertThat(Math.abs(either.gap() - gap)).as("draw %d", i).isLessThan(ROUND_OFF);
            }
        }
    }
}
