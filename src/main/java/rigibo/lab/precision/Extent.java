package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.precision.probe.Patience;

/** How much is measured, and how carefully. */
public enum Extent {
    /**
     * Presets and other engines only, as many processes side by side as there are cores: in a
     * minute and a half one sees where things are, but for the crowds, R14 to R16 and R20, each of
     * which takes minutes.
     */
    QUICK(new Patience(100, 100, 3, 500)),

    /**
     * Every setting, processes one after the other on the same core. A round of R11, the longest
     * but for the crowds, takes 1.5 s; of R14 to R16 and R20 every setting has one round.
     */
    FULL(new Patience(4000, 8000, 20, 40_000));

    private final Patience patience;

    Extent(Patience patience) {
        this.patience = patience;
    }

    Patience patience() {
        return patience;
    }

    /** Whether points along a line are measured. */
    boolean asks(Line line) {
        return this == FULL || line == Line.PRESETS || line == Line.PEERS;
    }
}
