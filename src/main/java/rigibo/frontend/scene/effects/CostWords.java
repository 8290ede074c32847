package rigibo.frontend.scene.effects;

import java.util.Locale;

/** What was measured, in words that claim no more than that. */
final class CostWords {

    private static final double MICROSECOND = 1e3;
    private static final double MILLISECOND = 1e6;

    private CostWords() {}

    /** What an effect that is simulated costs of a step. */
    static String ofLit(Estimate cost) {
        if (!cost.isKnown()) {
            return "costs …";
        }
        return isWithinNoise(cost)
                ? "costs less than the noise of " + time(bound(cost))
                : (cost.mean() > 0 ? "costs " : "saves ") + sure(cost);
    }

    /** What an effect that is not simulated would cost. */
    static String ofUnlit(Estimate cost) {
        if (!cost.isKnown()) {
            return "would cost … more";
        }
        return isWithinNoise(cost)
                ? "would cost less than the noise of " + time(bound(cost))
                : (cost.mean() > 0
                        ? "would cost " + sure(cost) + " more"
                        : "would save " + sure(cost));
    }

    /** What a step takes, ns, 0 where it is unknown. */
    static String ofStep(double nanos) {
        return "a step takes " + (nanos > 0 ? time(nanos) : "…");
    }

    private static boolean isWithinNoise(Estimate cost) {
        return Math.abs(cost.mean()) <= cost.noise();
    }

    private static double bound(Estimate cost) {
        return Math.abs(cost.mean()) + cost.noise();
    }

    private static String sure(Estimate cost) {
        return time(Math.abs(cost.mean())) + " ± " + time(cost.noise());
    }

    /** A time in ns with two or three digits that count. */
    static String time(double nanos) {
        if (nanos >= MILLISECOND) {
            return String.format(Locale.ROOT, "%.2f ms", nanos / MILLISECOND);
        }
        String format =
                nanos >= 100 * MICROSECOND
                        ? "%.0f µs"
                        : nanos >= 10 * MICROSECOND ? "%.1f µs" : "%.2f µs";
        return String.format(Locale.ROOT, format, nanos / MICROSECOND);
    }
}
