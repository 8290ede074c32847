package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Key;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * A demonstration of a level in all its states: untouched, pointed at, paused, lost by deleting one
 * box after another, and solved.
 */
final class StatesShow implements Demonstration {

    private static final int IDLE = 30;
    private static final int POINT = 40;
    private static final int HOVER = 60;
    private static final int PAUSE = 70;
    private static final int PAUSED = 80;
    private static final int RESUME = 90;

    /** Turns from the end of the lost try to its picture, and from there to the next try. */
    private static final int LOST_SEEN = 40;

    /** Turns from the victory to its picture; by then every medal is stamped. */
    private static final int WON_SEEN = 57;

    /** Rest of the cooldown in the picture of a cooldown. */
    private static final double COOLING = 0.6;

    private static final double HELD = 0.5;

    private final Session session;
    private final Camera camera;
    private final Supplier<Demonstration> solving;
    private Optional<Demonstration> solution = Optional.empty();
    private int turn;
    private int lostTurns;
    private int wonTurns;
    private Optional<String> last = Optional.empty();

    StatesShow(Session session, Camera camera, Supplier<Demonstration> solving) {
        this.session = session;
        this.camera = camera;
        this.solving = solving;
    }

    @Override
    public Optional<Click> pointer() {
        turn++;
        return turn == POINT ? firstBox() : Optional.empty();
    }

    @Override
    public Optional<Key> key() {
        if (turn == PAUSE || turn == RESUME) {
            return Optional.of(Key.P);
        }
        boolean isLost = solution.isEmpty() && session.game().outcome() != Outcome.RUNNING;
        if (isLost && ++lostTurns > LOST_SEEN) {
            solution = Optional.of(solving.get());
            return Optional.of(Key.R);
        }
        return Optional.empty();
    }

    @Override
    public Optional<Click> click() {
        if (solution.isPresent()) {
            return solution.get().click();
        }
        boolean isTime = turn > RESUME && session.game().cooldownLeft() == 0;
        boolean isRunning = session.game().outcome() == Outcome.RUNNING;
        return isTime && isRunning ? firstBox() : Optional.empty();
    }

    private Optional<Click> firstBox() {
        return session.game().targets().stream()
                .filter(Target::isClickable)
                .map(at -> new Click(camera.screenX(at.x()), camera.screenY(at.y())))
                .findFirst();
    }

    @Override
    public Optional<String> picture() {
        Optional<String> now = state();
        boolean isNew = now.isPresent() && !now.equals(last);
        last = now.or(() -> last);
        return isNew ? now : Optional.empty();
    }

    private Optional<String> state() {
        PuzzleGame game = session.game();
        if (solution.isPresent()) {
            return solvingState(game);
        }
        return switch (turn) {
            case IDLE -> Optional.of("idle");
            case HOVER -> Optional.of("hover");
            case PAUSED -> Optional.of("paused");
            default -> lostTurns == LOST_SEEN ? Optional.of("lost") : Optional.empty();
        };
    }

    private Optional<String> solvingState(PuzzleGame game) {
        if (game.outcome() == Outcome.WON) {
            return ++wonTurns == WON_SEEN ? Optional.of("won") : Optional.empty();
        }
        if (game.held() > HELD) {
            return Optional.of("hold");
        }
        boolean isCooling = game.clicks() == 1 && game.cooldownLeft() < COOLING;
        return isCooling && game.cooldownLeft() > 0 ? Optional.of("cooldown") : Optional.empty();
    }

    @Override
    public boolean isOver() {
        return solution.filter(Demonstration::isOver).isPresent();
    }

    @Override
    public boolean hasSucceeded() {
        return solution.filter(Demonstration::hasSucceeded).isPresent();
    }
}
