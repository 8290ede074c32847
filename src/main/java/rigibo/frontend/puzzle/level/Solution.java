package rigibo.frontend.puzzle.level;

import java.util.List;

/**
 * Clicks that win a level.
 *
 * @param clicks in the order they are made
 */
public record Solution(List<Click> clicks) {

    public Solution {
        clicks = List.copyOf(clicks);
    }
}
