package rigibo.frontend.puzzle.level;

import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * The numbers of the rules.
 *
 * @param cooldown s between two clicks; exactly at its end the next is allowed
 * @param hold s that the ball must stay on the platform
 * @param contactGrace s; a shorter bounce does not reset the hold clock
 * @param par clicks of a gold medal
 * @param maxClicks most clicks, where limited
 * @param timeLimit s, where limited
 */
public record Limits(
        double cooldown,
        double hold,
        double contactGrace,
        int par,
        OptionalInt maxClicks,
        OptionalDouble timeLimit) {

    public static final double USUAL_GRACE = 0.25;
}
