package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.hud.Command;
import rigibo.frontend.puzzle.hud.Panels;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.record.Tally;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.puzzle.show.Refusal;
import rigibo.frontend.puzzle.show.Table;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Director;

import java.util.EnumSet;
import java.util.Set;

/** Carries out the commands of a level, given by keys or buttons. */
final class Commands {

    private final Director director;
    private final Session session;
    private final View view;
    private final Table table;
    private final Panels panels;
    private final Tally tally;
    private final Sequel sequel;
    private final GhostSwitch ghost;

    Commands(
            Director director,
            Session session,
            View view,
            Table table,
            Panels panels,
            Tally tally,
            Sequel sequel) {
        this.director = director;
        this.session = session;
        this.view = view;
        this.table = table;
        this.panels = panels;
        this.tally = tally;
        this.sequel = sequel;
        ghost = new GhostSwitch(director, session, tally);
    }

    private Level level() {
        return session.own().level();
    }

    /** The level was solved, so a better run may exist to show as a ghost. */
    void solved() {
        ghost.solved();
    }

    /** The commands that are available at present, besides the permanent ones. */
    Set<Command> offered() {
        Set<Command> offered = EnumSet.noneOf(Command.class);
        if (ghost.isOffered()) {
            offered.add(Command.GHOST);
        }
        if (hasHint()) {
            offered.add(Command.HINT);
        }
        return offered;
    }

    private boolean hasHint() {
        return tally.failuresToHint() == 0;
    }

    void run(Command command) {
        switch (command) {
            case PAUSE, RESUME -> pause();
            case RESTART -> restart();
            case UNDO -> undo();
            case SLOWER -> session.pace(session.pace().next());
            case EFFECTS -> effects();
            case GHOST -> ghost();
            case HINT -> hint();
            case SOLUTION -> showSolution();
            case REPLAY -> session.showAgain();
            case COPY -> copy();
            case WHOLE -> view.showAll();
            case STOP -> session.stopShow();
            case NEXT, ENDLESS -> sequel.next().ifPresent(next -> director.show(next.get()));
            case LEVELS -> director.showLevels();
            case MENU, EDITOR -> director.showMenu();
        }
    }

    private void pause() {
        session.togglePause();
        table.letGo();
        panels.begin();
    }

    private void restart() {
        tally.givenUp(session.game());
        session.restart();
        ghost.begin();
    }

    private void undo() {
        if (!session.undo()) {
            table.refuse(Refusal.Reason.NO_UNDO);
        }
    }

    /** An experiment belongs to the player's own game, so a show uses the level's effects. */
    private void effects() {
        if (session.isShowing()) {
            table.refuse(Refusal.Reason.SHOWING);
        } else {
            panels.toggle(Panels.Drawer.EFFECTS);
        }
    }

    private void ghost() {
        if (session.isShowing()) {
            table.refuse(Refusal.Reason.SHOWING);
        } else if (!ghost.toggle()) {
            table.refuse(Refusal.Reason.NO_RUN_YET);
        }
    }

    private void hint() {
        if (hasHint() && !session.isShowing()) {
            panels.toggle(Panels.Drawer.HINT);
        } else {
            table.refuse(Refusal.Reason.NO_HINT_YET);
        }
    }

    /** Available only beside the hint, and not while something is shown. */
    private void showSolution() {
        if (panels.isOpen(Panels.Drawer.HINT) && !level().solutions().isEmpty()) {
            tally.givenUp(session.game());
            panels.shut();
            session.show(level().solutions().get(0));
        }
    }

    private void copy() {
        if (session.game().isSolved() && !session.isShowing()) {
            Replays.copy(director, Recording.of(session.game()));
        }
    }
}
