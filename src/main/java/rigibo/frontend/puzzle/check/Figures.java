package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Steps;

import java.util.List;
import java.util.Locale;

/**
 * The findings of a check about a level that is a puzzle.
 *
 * @param par clicks of its shortest solution
 * @param clickables number of targets
 * @param orders games of par clicks that the search played
 * @param wins how many of them were won
 * @param falseLeads first clicks that look right and lose, in the level's order
 * @param traps clicks of the solution without which the others look right and lose
 * @param wonAfter steps after which the stated solution wins
 * @param travel length of the ball's path until then, whole cm
 */
public record Figures(
        int par,
        int clickables,
        int orders,
        int wins,
        List<String> falseLeads,
        List<String> traps,
        int wonAfter,
        int travel) {

    private static final double PERCENT = 100;

    public Figures {
        falseLeads = List.copyOf(falseLeads);
        traps = List.copyOf(traps);
    }

    /** Share of the orders that win, 0 to 1. */
    public double share() {
        return orders == 0 ? 1 : wins / (double) orders;
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "par %d, %d boxes, %d of %d orders win (%.0f %%), misleads first: %s, misleads"
                        + " without: %s, won after %.2f s, the ball goes %.2f m",
                par,
                clickables,
                wins,
                orders,
                PERCENT * share(),
                words(falseLeads),
                words(traps),
                Steps.seconds(wonAfter),
                travel / PERCENT);
    }

    private static String words(List<String> ids) {
        return ids.isEmpty() ? "none" : String.join(" ", ids);
    }
}
