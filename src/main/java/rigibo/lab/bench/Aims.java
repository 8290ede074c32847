package rigibo.lab.bench;

import java.util.Map;
import java.util.OptionalDouble;

/** What we want to reach: times another engine takes, in times of ours. */
final class Aims {

    /** Of a step of ours: the 99th percentile in medians, at most. */
    static final double P99 = 2;

    /** Exponent of growth of the time of a step by the number of discs, at most. */
    static final double GROWTH = 1.1;

    private static final String GDX = "gdx-box2d";
    private static final String JBOX = "jbox2d";
    private static final String DYN4J = "dyn4j";

    private static final Map<String, Map<String, Double>> RATIOS =
            Map.of(
                    "large-pyramid", Map.of(GDX, 3.0, JBOX, 7.0, DYN4J, 15.0),
                    "many-pyramids", Map.of(GDX, 3.0, JBOX, 7.0, DYN4J, 15.0),
                    "tumbler", Map.of(GDX, 3.0, JBOX, 10.0, DYN4J, 15.0),
                    "flood", Map.of(GDX, 3.0, JBOX, 6.0, DYN4J, 7.0),
                    "free", Map.of(GDX, 5.0, JBOX, 25.0, DYN4J, 25.0));

    private Aims() {}

    /** Least ratio of an engine's time to ours that is wanted; empty where none is set. */
    static OptionalDouble ratio(String scene, String engine) {
        Double ratio = RATIOS.getOrDefault(scene, Map.of()).get(Inquiry.shortName(engine));
        return ratio == null ? OptionalDouble.empty() : OptionalDouble.of(ratio);
    }

    /** In words, where a value must not be less than its aim. */
    static String atLeast(double aim, double value) {
        return "≥ " + plain(aim) + verdict(value >= aim);
    }

    /** In words, where a value must not be more than its aim. */
    static String atMost(double aim, double value) {
        return "≤ " + plain(aim) + verdict(value <= aim);
    }

    private static String verdict(boolean isMet) {
        return isMet ? ": met" : ": not met";
    }

    private static String plain(double aim) {
        return aim == Math.rint(aim) ? "" + (long) aim : "" + aim;
    }
}
