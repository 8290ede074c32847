package rigibo.frontend.puzzle.rules;

import rigibo.backend.Pool;
import rigibo.frontend.puzzle.level.Steps;

import java.util.ArrayList;
import java.util.List;

/** Records hashes of a game's states, from its start to its end. */
final class Trace {

    /**
     * Steps between two hashes: few enough to locate a difference, and many enough for a small
     * file.
     */
    private static final int EVERY = Steps.of(0.5);

    private final List<Checkpoint> checkpoints = new ArrayList<>();

    Trace copy() {
        Trace copy = new Trace();
        copy.checkpoints.addAll(checkpoints);
        return copy;
    }

    /** Call at the start and after each step up to the end. */
    void observe(int steps, Outcome outcome, Pool pool) {
        if (steps % EVERY == 0 || outcome != Outcome.RUNNING) {
            checkpoints.add(new Checkpoint(steps, pool.stateHash()));
        }
    }

    List<Checkpoint> checkpoints() {
        return List.copyOf(checkpoints);
    }
}
