package rigibo.frontend.puzzle.rules;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.level.Verb;

import java.util.List;
import java.util.Optional;

/**
 * One attempt at a level. Clicks are made between steps, and the game is judged after each step.
 * After it is won or lost it keeps moving but is no longer judged.
 */
public final class PuzzleGame {

    private final Level level;
    private final Board board;
    private final List<Ride> rides;
    private final Workings workings;
    private final FireDoors doors;
    private final Cooldown cooldown;
    private final HoldClock hold;
    private final RestWatch rest;
    private final Optional<StarWatch> star;
    private final Trace trace;
    private final List<Act> acts;
    private Outcome outcome = Outcome.RUNNING;
    private Optional<Loss> loss = Optional.empty();
    private int steps;
    private int endedAt;
    private boolean isExperiment;
    private boolean isStarEarned;

    /** An attempt at its start. */
    public PuzzleGame(Level level, Accuracy accuracy) {
        this(level, Board.of(level, accuracy), Memory.atTheStart(level.limits()));
        trace.observe(steps, outcome, board.pool());
    }

    /** An attempt that goes on from the middle of another one. */
    PuzzleGame(Level level, Board board, Memory memory) {
        this.level = level;
        this.board = board;
        rides =
                board.pieces().stream()
                        .filter(piece -> piece.definition().path().isPresent())
                        .map(piece -> new Ride(piece.definition(), piece.body()))
                        .toList();
        workings = new Workings(board.pool(), board.pieces(), board.sources());
        doors = new FireDoors(board);
        star = level.star().map(one -> new StarWatch(one.feat(), board));
        cooldown = memory.cooldown();
        hold = memory.hold();
        rest = memory.rest();
        trace = memory.trace();
        acts = memory.acts();
        steps = memory.steps();
    }

    /** What the rules remember of a level that {@link Bookmarks#fit}; it shares nothing. */
    Memory memory() {
        return new Memory(steps, cooldown, hold, rest, trace, acts).copy();
    }

    /** Advances by 1/60 s. */
    public void step() {
        rides.forEach(ride -> ride.beforeStep(steps));
        workings.beforeStep(steps);
        doors.beforeStep(steps);
        board.pool().step(Steps.SECONDS);
        steps++;
        doors.afterStep(steps);
        if (outcome == Outcome.RUNNING) {
            star.ifPresent(StarWatch::observe);
        }
        board.forgetStrays();
        if (workings.isBurning() || doors.areMelting()) {
            rest.restart();
        } else {
            rest.observe(board);
        }
        if (outcome == Outcome.RUNNING) {
            judge();
            trace.observe(steps, outcome, board.pool());
        }
    }

    private void judge() {
        hold.observe(steps, board.ballsAreOnPlatform());
        if (hold.isHeld(steps)) {
            end(Outcome.WON, Optional.empty());
            isStarEarned = star.filter(one -> one.isEarned(acts, steps)).isPresent();
        } else if (board.ballHasLeft()) {
            lose(hold.hasTouched() ? Loss.ROLLED_OFF : Loss.LEFT_THE_WORLD);
        } else if (isTimeUp()) {
            lose(Loss.TIME_IS_UP);
        } else if (isStuck() && !canClick()) {
            lose(isOfBoxes() ? Loss.NOTHING_LEFT_TO_DELETE : Loss.NOTHING_LEFT_TO_CLICK);
        }
    }

    private boolean isTimeUp() {
        return level.limits().timeLimit().isPresent()
                && steps >= Steps.of(level.limits().timeLimit().getAsDouble());
    }

    private boolean canClick() {
        return board.hasClickable() && !areClicksUsedUp();
    }

    private boolean isOfBoxes() {
        return level.clickables().stream().allMatch(one -> one.verb() == Verb.DELETE);
    }

    private boolean areClicksUsedUp() {
        return level.limits().maxClicks().isPresent()
                && acts.size() >= level.limits().maxClicks().getAsInt();
    }

    private void lose(Loss reason) {
        end(Outcome.LOST, Optional.of(reason));
    }

    private void end(Outcome how, Optional<Loss> reason) {
        outcome = how;
        loss = reason;
        endedAt = steps;
    }

    /**
     * A click at a point of the world.
     *
     * @param x m
     * @param y m, up
     */
    public ClickResult click(double x, double y) {
        if (outcome != Outcome.RUNNING) {
            return ClickResult.OVER;
        }
        return targetAt(x, y).map(this::act).orElseGet(() -> nothing(x, y));
    }

    private ClickResult nothing(double x, double y) {
        return board.pool().bodyAt(x, y).isPresent()
                ? ClickResult.NOT_CLICKABLE
                : ClickResult.NOTHING_THERE;
    }

    /** Clicks a body or joint by its id, by the same rules as a click on it. */
    public ClickResult act(String id) {
        if (outcome != Outcome.RUNNING) {
            return ClickResult.OVER;
        }
        return board.target(id)
                .filter(Target::isAlive)
                .map(this::act)
                .orElse(ClickResult.NOTHING_THERE);
    }

    private ClickResult act(Target target) {
        if (!target.isClickable()) {
            return ClickResult.NOT_CLICKABLE;
        }
        if (areClicksUsedUp()) {
            return ClickResult.NO_CLICKS_LEFT;
        }
        if (!cooldown.isReady(steps)) {
            return ClickResult.COOLING_DOWN;
        }
        workings.act(target, steps);
        acts.add(new Act(steps, target.id()));
        cooldown.start(steps);
        rest.restart();
        return ClickResult.DONE;
    }

    /**
     * The level's body under a point, or the joint near it, clickable or not; never a ball or the
     * platform.
     */
    public Optional<Target> targetAt(double x, double y) {
        return board.targetAt(x, y);
    }

    public Level level() {
        return level;
    }

    public Outcome outcome() {
        return outcome;
    }

    /** The reason for a loss; empty if the game is not lost. */
    public Optional<Loss> loss() {
        return loss;
    }

    /** Steps made since the start. */
    public int steps() {
        return steps;
    }

    /** Time played, s; it stops with the outcome. */
    public double seconds() {
        return Steps.seconds(outcome == Outcome.RUNNING ? steps : endedAt);
    }

    /** Number of clicks so far that had an effect. */
    public int clicks() {
        return acts.size();
    }

    /** Rest of the cooldown: 1 just after a click, 0 when the next one is allowed. */
    public double cooldownLeft() {
        return cooldown.left(steps);
    }

    /** Share of the hold that has passed, 0 to 1. */
    public double held() {
        return outcome == Outcome.WON ? 1 : hold.fraction(steps);
    }

    /**
     * Whether everything is at rest and some ball is off the platform, so that only a click helps.
     */
    public boolean isStuck() {
        return rest.isAtRest() && !board.ballsAreOnPlatform();
    }

    /** Number of steps without motion; 0 as soon as a body moves. */
    public int stillSteps() {
        return rest.stillSteps();
    }

    /** The balls in the file's order; every one of them has to stay on the platform. */
    public List<RigidBody> balls() {
        return board.balls();
    }

    public RigidBody platform() {
        return board.platform();
    }

    /** The level's bodies in the file's order, including removed ones. */
    public List<Piece> pieces() {
        return board.pieces();
    }

    /** All bodies and joints with an id: the pieces, then the links; including removed ones. */
    public List<Target> targets() {
        return board.targets();
    }

    /** The body or joint of an id. */
    public Optional<Target> target(String id) {
        return board.target(id);
    }

    /** The clicks so far that had an effect. */
    public List<Act> acts() {
        return List.copyOf(acts);
    }

    /** The pool, read only: a change would break the promise of {@link #replay}. */
    public Pool pool() {
        return board.pool();
    }

    /**
     * Simulates other effects than the level declares. From then on this attempt is an experiment,
     * even if the effects are switched back, since their consequences remain.
     */
    public void experiment(Effects effects) {
        board.pool().effects(board.sources().in(effects));
        isExperiment = true;
    }

    /** Whether effects were switched; such an attempt earns no prize. */
    public boolean isExperiment() {
        return isExperiment;
    }

    /** Whether the level is solved under its own effects. */
    public boolean isSolved() {
        return outcome == Outcome.WON && !isExperiment;
    }

    /** Whether the level is solved in the way that earns its secret star. */
    public boolean hasStar() {
        return isSolved() && isStarEarned;
    }

    /** The game's states from its start to its end, at a fixed number of steps. */
    public List<Checkpoint> checkpoints() {
        return trace.checkpoints();
    }

    /**
     * The play so far, to be kept or played again. For an experiment it holds the clicks alone:
     * played again, they meet the level's own effects.
     */
    public Replay replay() {
        return new Replay(level.hash(), acts, board.pool().accuracy());
    }
}
