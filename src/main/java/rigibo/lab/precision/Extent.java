package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.precision.probe.Patience;

/** How much is measured, and how carefully. */
public enum Extent {
    /**
     * Presets and other engines only, an engine's settings in one process, as many processes side
     * by side as there are cores: in a minute and a half one sees where things are.
     */
    QUICK(new Patience(60, 30, 3, 150)),

    /** Every setting in a process of its own, one after the other on the same core. */
    FULL(new Patience(250, 250, 10, 800));

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
