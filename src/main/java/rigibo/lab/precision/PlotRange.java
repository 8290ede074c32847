package rigibo.lab.precision;

import rigibo.lab.plot.LogScale;

import java.util.List;
import java.util.stream.DoubleStream;

/** The ranges of cost and error in the figure of a problem. */
final class PlotRange {

    /** The factor left free at each end: room for a mark and its label. */
    private static final double ROOM = 1.6;

    /** The smallest error that is shown; below it all is rounding. */
    private static final double BELOW_ROUND_OFF = 0.5;

    private final List<Point> drawn;
    private final List<Point> timed;
    private final double leastError;

    PlotRange(Asked asked) {
        timed = asked.points().stream().filter(point -> point.cost() > 0).toList();
        drawn = timed.stream().filter(point -> !point.errors().hasFailed()).toList();
        double least = errors().filter(error -> error > 0).min().orElse(1);
        double shown = Math.max(least, BELOW_ROUND_OFF * ObservedOrder.ROUND_OFF);
        leastError = Math.pow(10, Math.floor(Math.log10(shown)));
    }

    private DoubleStream errors() {
        return drawn.stream().mapToDouble(point -> point.errors().main());
    }

    /** The points that were timed and did not fail. */
    List<Point> drawn() {
        return drawn;
    }

    /** The error at the lower edge; smaller ones are drawn there too. */
    double leastError() {
        return leastError;
    }

    boolean reachesBelow() {
        return errors().anyMatch(error -> error < leastError);
    }

    LogScale across(double left, double right) {
        double least = timed.stream().mapToDouble(Point::cost).min().orElse(1) / ROOM;
        double most = timed.stream().mapToDouble(Point::cost).max().orElse(1) * ROOM;
        return new LogScale(least, Math.max(most, 10 * least), left, right);
    }

    LogScale up(double bottom, double top) {
        double most = errors().max().orElse(1) * ROOM;
        return new LogScale(leastError, Math.max(most, 10 * leastError), bottom, top);
    }
}
