package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.record.Tally;
import rigibo.frontend.puzzle.session.BestRun;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Director;

import java.util.Optional;

/** Shows or hides the ghost of the player's best run, as chosen last in any level. */
final class GhostSwitch {

    private final Director director;
    private final Session session;
    private final Tally tally;

    /** Whether a run was kept, so that a ghost can be switched. */
    private boolean isOffered;

    /** Whether a kept run may be better than the one that is shown. */
    private boolean isOutdated = true;

    GhostSwitch(Director director, Session session, Tally tally) {
        this.director = director;
        this.session = session;
        this.tally = tally;
        isOffered = tally.hasRun();
        begin();
    }

    /** A try begins: the ghost becomes the best run kept so far. */
    void begin() {
        if (director.settings().hasGhost() && isOutdated) {
            session.ghost(tally.best().map(BestRun::new));
            isOutdated = false;
        }
    }

    /** The level was solved; a ghost on the screen stays until the next try. */
    void solved() {
        isOffered = tally.hasRun();
        isOutdated = true;
    }

    /** Whether there is a run to show, so that its key is offered. */
    boolean isOffered() {
        return isOffered;
    }

    /** Switches the ghost; returns whether there is a run to show. */
    boolean toggle() {
        if (!isOffered) {
            return false;
        }
        boolean isShown = session.hasGhost();
        director.settings(director.settings().withGhost(!isShown));
        session.ghost(isShown ? Optional.empty() : tally.best().map(BestRun::new));
        isOutdated = isShown;
        return isShown || session.hasGhost();
    }
}
