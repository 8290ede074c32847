package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Demonstration;

import java.util.Optional;

/** Plays a stored solution by pointer: each click hits the middle of its target at its step. */
final class SolutionShow implements Demonstration {

    private final Session session;
    private final Camera camera;
    private final Solution solution;
    private int next;

    SolutionShow(Session session, Camera camera, Solution solution) {
        this.session = session;
        this.camera = camera;
        this.solution = solution;
    }

    @Override
    public Optional<Demonstration.Click> click() {
        if (next == solution.clicks().size()) {
            return Optional.empty();
        }
        var wanted = solution.clicks().get(next);
        if (session.game().steps() < Steps.of(wanted.seconds())) {
            return Optional.empty();
        }
        next++;
        return session.game().target(wanted.target()).filter(Target::isClickable).map(this::at);
    }

    private Demonstration.Click at(Target target) {
        return new Demonstration.Click(camera.screenX(target.x()), camera.screenY(target.y()));
    }

    @Override
    public boolean isOver() {
        return session.game().outcome() != Outcome.RUNNING;
    }

    @Override
    public boolean hasSucceeded() {
        return session.game().isSolved();
    }
}
