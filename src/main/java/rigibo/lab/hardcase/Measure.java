package rigibo.lab.hardcase;

import java.util.Locale;

/**
 * One figure of a case: an error or a count, so less is better.
 *
 * @param name what was measured
 * @param figure the worst value seen
 * @param limit the largest value that passes; infinite where the figure is only reported
 * @param unit of both
 * @param where in which variant and step of the case the worst value was seen
 */
public record Measure(String name, double figure, double limit, String unit, String where) {

    /** Whether the figure keeps its limit; NaN does not. */
    public boolean passes() {
        return figure <= limit;
    }

    /** The limit over the figure; infinite if the figure is 0 or has no limit. */
    public double margin() {
        if (Double.isNaN(figure)) {
            return 0;
        }
        return figure <= 0 || isReported() ? Double.POSITIVE_INFINITY : limit / figure;
    }

    /** Whether the figure has no limit. */
    public boolean isReported() {
        return limit == Double.POSITIVE_INFINITY;
    }

    /** The worse of two values of the same measure. */
    Measure worse(Measure other) {
        return other.figure > figure || Double.isNaN(other.figure) ? other : this;
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "%-4s %-44s %12.4g of %-10.4g %-7s %s",
                passes() ? "ok" : "FAIL",
                name,
                figure,
                limit,
                unit,
                where);
    }
}
