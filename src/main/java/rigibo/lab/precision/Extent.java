package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.precision.probe.Patience;
import rigibo.lab.problem.Problem;

/** How much is measured and how carefully. */
public enum Extent {
    /**
     * Presets and other engines only, with one process per core. It takes a minute and a half, plus
     * minutes for each long problem.
     */
    QUICK(new Patience(100, 100, 3, 500)),

    /** All settings, with one process at a time on the same core. */
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
