package rigibo.backend;

/** Whether a pool is in a step or a visitor's call; refuses what may not happen meanwhile. */
final class Busy {

    private boolean isStepping;

    /** Calls of {@code forEach…} methods that have not returned yet. */
    private int visits;

    void beginStep() {
        isStepping = true;
    }

    void endStep() {
        isStepping = false;
    }

    void beginVisit() {
        visits++;
    }

    void endVisit() {
        visits--;
    }

    boolean isVisited() {
        return visits > 0;
    }

    /**
     * Refuses reads while a step writes.
     *
     * @throws IllegalStateException within a step
     */
    void requireBetweenSteps(String what) {
        if (isStepping) {
            throw new IllegalStateException("cannot " + what + " during a step");
        }
    }

    /**
     * Refuses changes during a step or a visit.
     *
     * @throws IllegalStateException within a step or a visitor's call
     */
    void requireChangeable(String what) {
        requireBetweenSteps(what);
        if (isVisited()) {
            throw new IllegalStateException("cannot " + what + " while contacts are visited");
        }
    }
}
