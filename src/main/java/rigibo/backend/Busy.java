package rigibo.backend;

/** What a pool is in the midst of, and what it therefore refuses. */
final class Busy {

    private boolean isStepping;

    /** Visits of contacts that have not come to their end. */
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
     * Refuses to read what a step is writing.
     *
     * @throws IllegalStateException within a step
     */
    void requireBetweenSteps(String what) {
        if (isStepping) {
            throw new IllegalStateException("cannot " + what + " during a step");
        }
    }

    /**
     * Refuses to change what is being worked on or looked at.
     *
     * @throws IllegalStateException within a step or a visit of contacts
     */
    void requireChangeable(String what) {
        requireBetweenSteps(what);
        if (isVisited()) {
            throw new IllegalStateException("cannot " + what + " while contacts are visited");
        }
    }
}
