package rigibo.frontend.demo;

import rigibo.backend.StepReport;

/**
 * A number of workers, the times of the steps they made, and the most bodies they held at 60 Hz.
 */
final class Crew {

    final int workers;
    final FrameTimes times = new FrameTimes();
    private boolean isSearched;
    private int heldDrawn;
    private int heldAlone;

    Crew(int workers) {
        this.workers = workers;
    }

    /** Begins the search for the most bodies anew. */
    void beginSearch() {
        isSearched = false;
        heldDrawn = 0;
        heldAlone = 0;
        times.forget();
    }

    /**
     * Takes in a step of the search with a number of bodies; returns whether the search goes on.
     */
    boolean goesOn(StepReport report, int bodies) {
        times.step(report);
        if (!times.isMeasured()) {
            return true;
        }
        isSearched = true;
        heldDrawn = times.frameHolds() ? bodies : heldDrawn;
        heldAlone = times.stepHolds() ? bodies : heldAlone;
        return times.stepHolds();
    }

    /** Whether a search has measured any number of bodies. */
    boolean isSearched() {
        return isSearched;
    }

    /** The most bodies held with drawing; 0 before a search, and where none were. */
    int heldDrawn() {
        return heldDrawn;
    }

    /** The most bodies held without drawing; 0 before a search, and where none were. */
    int heldAlone() {
        return heldAlone;
    }
}
