package rigibo.frontend.scene.effects;

import rigibo.frontend.scene.Words;

/**
 * Words a measured cost without claiming more than was measured.
 *
 * @param words the player's
 */
record CostWords(Words words) {

    private static final double MICROSECOND = 1e3;
    private static final double MILLISECOND = 1e6;

    /** Says which share of a step a simulated effect costs. */
    String ofLit(Estimate cost) {
        return of("cost.lit", cost);
    }

    /** Says what an effect that is not simulated would cost. */
    String ofUnlit(Estimate cost) {
        return of("cost.unlit", cost);
    }

    private String of(String key, Estimate cost) {
        if (!cost.isKnown()) {
            return words.of(key + ".unknown");
        }
        return isWithinNoise(cost)
                ? words.of(key + ".noise", time(bound(cost)))
                : words.of(key + (cost.mean() > 0 ? ".more" : ".less"), sure(cost));
    }

    /** Says how long a step takes, ns; 0 where it is unknown. */
    String ofStep(double nanos) {
        return words.of("cost.step", nanos > 0 ? time(nanos) : "…");
    }

    private static boolean isWithinNoise(Estimate cost) {
        return Math.abs(cost.mean()) <= cost.noise();
    }

    private static double bound(Estimate cost) {
        return Math.abs(cost.mean()) + cost.noise();
    }

    private String sure(Estimate cost) {
        return time(Math.abs(cost.mean())) + " ± " + time(cost.noise());
    }

    /** A time in ns with two or three digits that count. */
    String time(double nanos) {
        if (nanos >= MILLISECOND) {
            return words.number("%.2f ms", nanos / MILLISECOND);
        }
        String format =
                nanos >= 100 * MICROSECOND
                        ? "%.0f µs"
                        : nanos >= 10 * MICROSECOND ? "%.1f µs" : "%.2f µs";
        return words.number(format, nanos / MICROSECOND);
    }
}
