package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Kicks against the solutions of q̈ + 2λ·q̇ + ω²·q = 0 by the roots of r² + 2λ·r + ω² = 0. Times
 * and compared values are of the order of 1, so that 1e-12 is some thousand times round-off.
 */
class DampedSwingTest {

    private static final double ROUND_OFF = 1e-12;
    private static final double X = 0.7;
    private static final double V = -0.4;

    private final DampedSwing swing = new DampedSwing();

    /** Under a damping ratio of 1, above it, and with no spring at all. */
    @ParameterizedTest
    @CsvSource({
        "9, 0.5, 0.1, 0.1",
        "9, 0.5, 0.1, 0.03",
        "9, 0, 0.2, 0.1",
        "9, 5, 0.1, 0.2",
        "0, 3, 0.1, 0.2",
        "9, 0.5, 0.1, -0.15",
        "9, 0.5, -0.15, 0.1",
    })
    void kicksLeadFromDriftToDriftAlongTheTruth(
            double square, double decay, double before, double after) {
        double earlier = place(square, decay, -before);
        double later = place(square, decay, after);
        swing.between(square, decay, before, after);
        double next = swing.kept * (X - earlier) / before - swing.pulled * X;
        assertThat(X + next * after).isCloseTo(later, within(ROUND_OFF));
    }

    /** Velocities at the start and at the end are the present ones. */
    @ParameterizedTest
    @CsvSource({"9, 0.5, 0.1", "9, 5, 0.1", "9, 0.5, -0.1"})
    void startsAndEndsHaveVelocitiesOfNow(double square, double decay, double drift) {
        swing.between(square, decay, 0, drift);
        double next = swing.kept * V - swing.pulled * X;
        assertThat(X + next * drift).isCloseTo(place(square, decay, drift), within(ROUND_OFF));
        double earlier = place(square, decay, -drift);
        swing.between(square, decay, drift, 0);
        double last = swing.kept * (X - earlier) / drift - swing.pulled * X;
        assertThat(last).isCloseTo(V, within(ROUND_OFF));
    }

    /** With a damping ratio of 1 both roots are −λ: q = (q₀ + (q̇₀ + λ·q₀)·t)·e^(−λt). */
    @ParameterizedTest
    @CsvSource({"3, 0.1", "3, -0.1"})
    void aDampingRatioOfOneNeitherSwingsNorCreeps(double decay, double time) {
        swing.between(decay * decay, decay, 0, time);
        double next = swing.kept * V - swing.pulled * X;
        double truth = (X + (V + decay * X) * time) * Math.exp(-decay * time);
        assertThat(X + next * time).isCloseTo(truth, within(ROUND_OFF));
    }

    /** The displacement after a time, from X and V. */
    private static double place(double square, double decay, double time) {
        double root = Math.sqrt(Math.abs(square - decay * decay));
        if (square > decay * decay) {
            double across = (V + decay * X) / root;
            double wave = X * Math.cos(root * time) + across * Math.sin(root * time);
            return Math.exp(-decay * time) * wave;
        }
        double slow = root - decay;
        double fast = -root - decay;
        double ofFast = (V - slow * X) / (fast - slow);
        return (X - ofFast) * Math.exp(slow * time) + ofFast * Math.exp(fast * time);
    }
}
