package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.precision.probe.Patience;
import rigibo.lab.problem.Problem;

/** How much is measured, and how carefully. */
public enum Extent {
    /**
     * Presets and other engines only, as many processes side by side as there are cores: in a
     * minute and a half one sees where things are, but for the long problems, each of which takes
     * minutes.
     */
    QUICK(new Patience(100, 100, 3, 500)),

    /** Every setting, processes one after the other on the same core. */
    FULL(new Patience(4000, 8000, 20, 40_000));

    private final Patience patience;

    Extent(Patience patience) {
        this.patience = patience;
    }

    Patience patience(Problem problem) {
        return problem.isLong() ? Patience.ONE_RUN : patience;
    }

    /** Whether points along a line are measured. */
    boolean asks(Line line) {
        return this == FULL || line == Line.PRESETS || line == Line.PEERS;
    }
}
