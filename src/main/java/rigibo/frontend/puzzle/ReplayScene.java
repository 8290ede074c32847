package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.hud.ReplayBar;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.Verdict;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Enlarged;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Scenery;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.HandButtons;
import rigibo.frontend.scene.widget.HandFrame;
import rigibo.frontend.scene.widget.WholePlate;

import java.util.List;
import java.util.Optional;

/** Shows a recorded run, and at its end whether every state was the same to the last bit. */
final class ReplayScene implements Scene {

    private final Director director;
    private final Recording recording;
    private final Audience audience;
    private final View view;
    private final ReplayBar bar;
    private final HandButtons buttons = new HandButtons();
    private final WholePlate whole;
    private Screening screening;
    private ReplaySpeed speed = ReplaySpeed.FULL;
    private boolean isPaused;

    /** The audience for which a recording is shown. */
    enum Audience {
        PLAYER,
        /** A film: nobody can press a key, so none is shown. */
        FILM
    }

    ReplayScene(Director director, Recording recording, Audience audience) {
        this.director = director;
        this.audience = audience;
        this.recording = recording;
        view = new View(recording.level());
        bar = new ReplayBar(recording);
        whole = new WholePlate(director.words());
        begin();
    }

    private void begin() {
        screening = new Screening(recording, view.camera(), director.sounds());
        isPaused = false;
    }

    @Override
    public String title() {
        String level = recording.level().title().in(director.words().locale());
        return "RigiBo – " + director.words().of("replay.title", level);
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
        if (!isPaused) {
            screening.turn(speed, motion());
        }
    }

    private Motion motion() {
        return director.settings().motion();
    }

    @Override
    public void draw(Canvas canvas) {
        PuzzleGame game = screening.game();
        screening.draw(canvas, motion());
        buttons.clear();
        whole.hide();
        if (view.isEnlarged()) {
            whole.draw(canvas, View.KEYS_TOP);
        }
        if (canvas.layout().isInHand() && audience == Audience.PLAYER) {
            drawInHand(canvas, game);
            return;
        }
        bar.draw(canvas, director.words(), game, state());
        drawVerdict(canvas, View.BAR_FOOT);
        if (audience == Audience.PLAYER) {
            bar.drawKeys(canvas, director.words());
        }
    }

    private void drawInHand(Canvas canvas, PuzzleGame game) {
        Enlarged enlarged = new Enlarged(canvas);
        List<HandButtons.Item> items = items();
        HandFrame frame = HandFrame.of(enlarged.layout(), items.size(), 0);
        buttons.draw(enlarged, frame.buttons(), items);
        double end = bar.drawInHand(enlarged, frame.free(), director.words(), game, state());
        drawVerdict(canvas, canvas.layout().isUpright() ? enlarged.outY(end) : 0);
    }

    @Override
    public void describe(Narrator narrator) {
        buttons.describe(narrator);
        whole.describe(narrator);
        narrator.says(state());
        screening.verdict().ifPresent(verdict -> narrator.says(verdict.in(director.words())));
    }

    private List<HandButtons.Item> items() {
        Words words = director.words();
        return List.of(
                new HandButtons.Item(words.of("puzzle.command.menu"), director::showMenu),
                new HandButtons.Item(words.of("puzzle.command.pause"), isPaused, this::pause),
                new HandButtons.Item(speed.words(), () -> speed = speed.next()),
                new HandButtons.Item(words.of("puzzle.command.restart"), this::begin),
                new HandButtons.Item(
                        words.of("puzzle.short.copy"), () -> Replays.copy(director, recording)));
    }

    private void drawVerdict(Canvas canvas, double end) {
        screening
                .verdict()
                .ifPresent(verdict -> bar.drawVerdict(canvas, director.words(), verdict, end));
    }

    private void pause() {
        isPaused = !isPaused;
    }

    private String state() {
        return isPaused
                ? director.words().of("replay.paused")
                : director.words().of("replay.running", speed.words());
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        buttons.at(x, y).map(HandButtons.Item::action).orElseGet(() -> beside(x, y)).run();
    }

    private Runnable beside(double x, double y) {
        return whole.contains(x, y) ? view::showAll : this::pause;
    }

    @Override
    public void pinched(Pinch pinch) {
        view.pinch(pinch);
    }

    @Override
    public Tap tap(double x, double y) {
        return Tap.LIFTED;
    }

    @Override
    public Optional<Action.Place> place() {
        return Optional.of(Action.Place.REPLAY);
    }

    @Override
    public void keyPressed(Key key) {
        switch (key) {
            case SPACE, P -> pause();
            case PERIOD -> stepOnce();
            case LEFT, S -> speed = speed.slower();
            case RIGHT, N -> speed = speed.faster();
            case R -> begin();
            case HOME -> view.showAll();
            case C -> Replays.copy(director, recording);
            default -> {}
        }
    }

    @Override
    public Optional<Demonstration> demonstration() {
        return Optional.of(new Performance());
    }

    /** Plays without input until there is a verdict; succeeds if the verdict is good. */
    private final class Performance implements Demonstration {

        @Override
        public Optional<Click> click() {
            return Optional.empty();
        }

        @Override
        public boolean isOver() {
            return screening.verdict().isPresent();
        }

        @Override
        public boolean hasSucceeded() {
            return screening.verdict().filter(Verdict::isSame).isPresent();
        }
    }

    private void stepOnce() {
        isPaused = true;
        screening.turn(ReplaySpeed.FULL, motion());
    }
}
