package rigibo.backend.contact.joint;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Exponential;

/**
 * How kicks follow q̈ + 2λ·q̇ + ω²·q = 0 exactly. Its solutions are q(t) = A(t)·q₀ + B(t)·q̇₀ with
 * A = e^(−λt)·(C + λ·S) and B = e^(−λt)·S, where C = cos ω′t, S = sin(ω′t)/ω′, ω′² = ω² − λ²;
 * beyond a damping ratio of 1 these are hyperbolic. A drift in a straight line from q₀ to q(t) has
 * the velocity (q(t) − q₀)/t, so that a kick leads from the velocity of one drift to that of the
 * next one by w₁ = kept·w₀ − pulled·q.
 */
final class DampedSwing {

    /** Length of the drift before, as a share of the drift after, up to which it counts as 0. */
    private static final double INSTANT = 1e-5;

    /** λ in 1/s, and ω² − λ² in 1/s². */
    private double decay;

    private double square;

    /** A, and B in s, at the time computed last. */
    private double a;

    private double b;

    /** Share of the velocity that a kick keeps. */
    double kept;

    /** Velocity that a kick takes per unit of displacement, 1/s. */
    double pulled;

    /**
     * Finds a kick between two drifts.
     *
     * @param frequencySquare ω² in 1/s²
     * @param decayRate λ in 1/s
     * @param before length of the drift before, s; 0 at the start, where velocities are the present
     *     ones
     * @param after length of the drift after, s; 0 at the end, where velocities are to be the
     *     present ones
     */
    void between(double frequencySquare, double decayRate, double before, double after) {
        decay = decayRate;
        square = frequencySquare - decayRate * decayRate;
        // First from the drift before to the present velocity, then on to the drift after.
        kept = 1;
        pulled = 0;
        if (Math.abs(before) > INSTANT * Math.abs(after)) {
            find(-before);
            kept = -before / b;
            pulled = (a - 1) / b;
        }
        if (after != 0) {
            find(after);
            kept *= b / after;
            pulled = (1 - a + b * pulled) / after;
        }
    }

    private void find(double time) {
        double cosine;
        double sine;
        double rate = Math.sqrt(Math.abs(square));
        double phase = rate * time;
        if (rate == 0) {
            cosine = 1;
            sine = time;
        } else if (square > 0) {
            cosine = Angle.cos(phase);
            sine = Angle.sin(phase) / rate;
        } else {
            double grows = Exponential.exp(phase);
            cosine = (grows + 1 / grows) / 2;
            sine = (grows - 1 / grows) / (2 * rate);
        }
        double fades = Exponential.exp(-decay * time);
        a = fades * (cosine + decay * sine);
        b = fades * sine;
    }
}
