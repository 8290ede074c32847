package rigibo.frontend.puzzle;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.hud.Command;
import rigibo.frontend.puzzle.hud.Lesson;
import rigibo.frontend.puzzle.hud.Panels;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.record.Ledger;
import rigibo.frontend.puzzle.record.Tally;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.session.Pace;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.puzzle.show.Table;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.Modifier;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Scenery;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Tap;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** A level in play: passes the player's input to the play and to the panels around it. */
public final class PuzzleScene implements Scene {

    /** Name of the parameter in links. */
    private static final String PACE = "pace";

    private final Director director;
    private final Level level;
    private final Sequel sequel;

    /** Whether it is the game's first level, whose demonstration shows all of its states. */
    private final boolean isFirst;

    private final Session session;
    private final View view;
    private final Table table;
    private final Panels panels;
    private final Tally tally;
    private final Lesson lesson;
    private final Commands commands;
    private Optional<Solution> solution = Optional.empty();
    private boolean isShiftHeld;

    /** One of several levels, played in their order. */
    public PuzzleScene(Director director, List<Level> levels, int number) {
        this(
                director,
                levels.get(number),
                new Tally(director, levels.get(number)),
                Sequel.of(director, levels, number),
                Lesson.of(levels, number, Levels.isSolved(director, levels.get(number))),
                number == 0 && levels.size() > 1);
    }

    /** A draft that is tried out; every way leads back to the editor. */
    public static PuzzleScene ofTrial(Director director, Level level) {
        return new PuzzleScene(
                director,
                level,
                new Tally(director, level),
                Sequel.backToTheEditor(),
                Lesson.none(),
                false);
    }

    /** A level made by chance, with a ledger and a sequel of its own and without a lesson. */
    PuzzleScene(Director director, Level level, Ledger ledger, Sequel sequel) {
        this(director, level, new Tally(director, level, ledger), sequel, Lesson.none(), false);
    }

    private PuzzleScene(
            Director director,
            Level level,
            Tally tally,
            Sequel sequel,
            Lesson lesson,
            boolean isFirst) {
        this.director = director;
        this.level = level;
        this.tally = tally;
        this.sequel = sequel;
        this.isFirst = isFirst;
        session = new Session(level, Accuracy.GAME);
        view = new View(level);
        table = new Table(session, view.camera(), director.sounds());
        this.lesson = lesson;
        panels = new Panels(level, session, view, director.words(), lesson, sequel.exits());
        commands = new Commands(director, session, view, table, panels, tally, sequel);
    }

    @Override
    public String title() {
        return "RigiBo – " + level.title().in(director.words().locale());
    }

    /** Links carry the pace but no accuracy, since solutions are proved at one accuracy. */
    @Override
    public Link link() {
        if (!Levels.isOfTheGame(level)) {
            return Link.MENU;
        }
        Link link = Link.to(level.id());
        Pace pace = session.pace();
        return pace == Pace.FULL ? link : link.with(PACE, pace.linked());
    }

    @Override
    public boolean follow(Link link) {
        Optional<Pace> pace = Pace.ofLinked(link.choices().getOrDefault(PACE, ""));
        pace.ifPresent(session::pace);
        return link.choices().size() == (pace.isPresent() ? 1 : 0);
    }

    @Override
    public Scenery scenery() {
        return view.scenery();
    }

    @Override
    public boolean isForHands() {
        return true;
    }

    @Override
    public void step() {
        PuzzleGame game = session.game();
        boolean wasRunning = game.outcome() == Outcome.RUNNING;
        table.frame();
        if (wasRunning && !session.isShowing()) {
            tally.observe(game);
            if (game.outcome() != Outcome.RUNNING) {
                ended(game);
            }
        }
        panels.turn();
        lesson.turn();
    }

    /** Records the game before a click, so that a click in the first turn of a try is counted. */
    private void count() {
        if (session.own().outcome() == Outcome.RUNNING) {
            tally.observe(session.own());
        }
    }

    private void ended(PuzzleGame game) {
        tally.ended(game);
        table.letGo();
        // The end is shown in the whole picture.
        view.showAll();
        panels.end(game, sequel.next().map(way -> sequel.onward()), tally.hasStar());
        if (game.isSolved()) {
            solution = Optional.of(game.replay().solution());
            commands.solved();
            table.celebrate(motion());
        }
    }

    private Motion motion() {
        return director.settings().motion();
    }

    @Override
    public void draw(Canvas canvas) {
        panels.layOut(canvas.layout());
        table.draw(canvas, motion());
        lesson.draw(canvas, session, view.camera(), motion());
        panels.draw(canvas, table.refusal(), commands.offered(), motion());
        table.drawPointer(canvas, motion());
    }

    @Override
    public void describe(Narrator narrator) {
        panels.describe(narrator, table.refusal());
        table.describe(
                narrator,
                director.words(),
                (x, y) -> panels.at(x, y).isPresent() || panels.cover(x, y));
    }

    @Override
    public void drawn(long nanos) {
        panels.drawn();
    }

    @Override
    public void paced(double share) {
        panels.paced(share);
    }

    @Override
    public void closed() {
        tally.left(session.own());
        panels.close();
        sequel.close();
    }

    @Override
    public void pointerMoved(double x, double y) {
        table.point(x, y);
        panels.pointerMoved(x, y);
    }

    @Override
    public Tap tap(double x, double y) {
        boolean isOnPanel = panels.at(x, y).isPresent() || panels.cover(x, y);
        return isOnPanel ? Tap.LIFTED : Tap.CHOSEN;
    }

    @Override
    public void choosing(boolean isChoosing) {
        table.choosing(isChoosing);
    }

    @Override
    public void pinched(Pinch pinch) {
        view.pinch(pinch);
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        pointerMoved(x, y);
        if (button != PointerButton.LEFT) {
            return;
        }
        Optional<Command> command = panels.at(x, y);
        if (command.isPresent()) {
            commands.run(command.get());
        } else if (panels.cover(x, y)) {
            panels.press(x, y);
        } else {
            count();
            table.click(x, y);
        }
    }

    @Override
    public void held(Set<Modifier> modifiers) {
        isShiftHeld = modifiers.contains(Modifier.SHIFT);
    }

    @Override
    public Optional<Action.Place> place() {
        return Optional.of(Action.Place.LEVEL);
    }

    @Override
    public void keyPressed(Key key) {
        switch (key) {
            case R -> commands.run(session.isShowing() ? Command.STOP : Command.RESTART);
            case P -> commands.run(Command.PAUSE);
            case E -> commands.run(Command.EFFECTS);
            case G -> commands.run(Command.GHOST);
            case H -> commands.run(Command.HINT);
            case V -> commands.run(Command.SOLUTION);
            case C -> commands.run(Command.COPY);
            case BACKSPACE -> commands.run(Command.UNDO);
            case HOME -> commands.run(Command.WHOLE);
            case S -> session.pace(session.pace().slower());
            case N -> session.pace(session.pace().faster());
            case TAB -> cycle(isShiftHeld ? -1 : 1);
            case UP, DOWN, LEFT, RIGHT -> arrow(key);
            case ENTER -> enter();
            default -> {}
        }
    }

    /** Selects the next target, and no button. */
    private void cycle(int direction) {
        panels.letGo();
        table.cycle(direction);
    }

    /** Left and right select a button if there are any; otherwise arrows select a target. */
    private void arrow(Key key) {
        boolean isAcross = key == Key.LEFT || key == Key.RIGHT;
        if (panels.hasButtons() && (isAcross || panels.isOver())) {
            table.letGo();
            panels.move(key == Key.LEFT || key == Key.UP ? -1 : 1);
        } else {
            panels.letGo();
            table.move(key);
        }
    }

    /** Clicks the selected target, or presses the selected button. */
    private void enter() {
        count();
        if (!table.clickChosen()) {
            panels.chosen().ifPresent(commands::run);
        }
    }

    @Override
    public boolean escaped() {
        boolean isShowing = session.isShowing();
        if (isShowing) {
            session.stopShow();
        }
        return isShowing;
    }

    /** The clicks with which the player last solved the level; empty before that. */
    public Optional<Solution> solution() {
        return solution;
    }

    /** Shows the first level in all its states. */
    @Override
    public Optional<Demonstration> demonstration() {
        if (level.solutions().isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(
                isFirst ? new StatesShow(session, view.camera(), this::solving) : solving());
    }

    private Demonstration solving() {
        return new SolutionShow(session, view.camera(), level.solutions().get(0));
    }
}
