package rigibo.lab.problem;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The errors of a run.
 *
 * @param main the error of the problem, averaged over its phases; NaN if the run failed
 * @param others further errors, each named with its unit, in the order they are told
 * @param failure why the run failed, such as "ball 3 went through the floor"; empty if it did not
 */
public record Errors(double main, Map<String, Double> others, String failure) {

    /** The errors of a finished run; the run failed if its error is not finite. */
    public static Errors of(double main) {
        boolean isFinite = Double.isFinite(main);
        return new Errors(
                isFinite ? main : Double.NaN, Map.of(), isFinite ? "" : "no longer finite");
    }

    /** A run that failed. */
    public static Errors failed(String why) {
        return new Errors(Double.NaN, Map.of(), why);
    }

    /** A copy with one more error, named with its unit. */
    public Errors with(String name, double error) {
        Map<String, Double> more = new LinkedHashMap<>(others);
        more.put(name, error);
        return new Errors(main, more, failure);
    }

    /** Whether the run failed. */
    public boolean hasFailed() {
        return !failure.isEmpty();
    }
}
