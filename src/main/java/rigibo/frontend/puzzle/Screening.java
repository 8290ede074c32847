package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.Verdict;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.puzzle.show.Table;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Sounds;

import java.util.Optional;

/** A replay on the screen, shown once from start to end. */
final class Screening {

    private final Session session;
    private final Table table;

    Screening(Recording recording, Camera camera, Sounds sounds) {
        session = Session.watching(recording);
        table = new Table(session, camera, sounds);
    }

    /** Makes a turn of 1/60 s at a speed. */
    void turn(ReplaySpeed speed, Motion motion) {
        if (session.pace() != speed.pace()) {
            session.pace(speed.pace());
        }
        for (int frame = 0; frame < speed.framesPerTurn(); frame++) {
            boolean wasRunning = game().outcome() == Outcome.RUNNING;
            table.frame();
            if (wasRunning && game().isSolved()) {
                table.celebrate(motion);
            }
        }
    }

    void draw(Canvas canvas, Motion motion) {
        table.draw(canvas, motion);
    }

    PuzzleGame game() {
        return session.game();
    }

    Optional<Verdict> verdict() {
        return session.verdict();
    }
}
