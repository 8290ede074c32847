package rigibo.lab.bench;

import java.util.Map;
import java.util.OptionalDouble;

/** The aims of the bench: how many times as long as ours another engine should take. */
final class Aims {

    /** The most that the 99th percentile of our steps may be, as a multiple of their median. */
    static final double P99 = 2;

    /** The largest exponent with which our step may grow with the number of discs. */
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

    /** The ratio of an engine's time to ours that we aim for; empty where none is set. */
    static OptionalDouble ratio(String scene, String engine) {
        Double ratio = RATIOS.getOrDefault(scene, Map.of()).get(Inquiry.shortName(engine));
        return ratio == null ? OptionalDouble.empty() : OptionalDouble.of(ratio);
    }

    /** Words for an aim that a value should reach. */
    static String atLeast(double aim, double value) {
        return "≥ " + plain(aim) + verdict(value >= aim);
    }

    /** Words for an aim that a value should not exceed. */
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
