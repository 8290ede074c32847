package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Badge;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.ghost.Divergence;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Two accuracies side by side, started from the same state, in real time or as near to it as
 * possible.
 */
final class LaboratoryScene implements Scene {

    private static final double EDGE = 8;
    private static final double PLATE_WIDTH = WIDTH - 2 * EDGE;
    private static final double HALVES_TOP = EDGE + ExperimentBar.HEIGHT + 6;
    private static final double STATUS_TOP = HALVES_TOP + HalfView.HEIGHT + 6;
    private static final double STATUS_HEIGHT = 34;
    private static final double CURVE_TOP = STATUS_TOP + STATUS_HEIGHT + 6;

    private final Words words;
    private final List<Experiment> experiments = Experiments.all();
    private final Half left = new Half(Preset.GAME);
    private final Half right = new Half(Preset.EXACT);
    private final HalfView leftView;
    private final HalfView rightView;
    private final ExperimentBar bar;
    private final DistancePlate plate;
    private Room room;
    private Divergence divergence;
    private int chosen;

    /** Share of real time at which the loop runs. */
    private double pace = 1;

    private int turn;
    private boolean isPaused;

    LaboratoryScene(Words words) {
        this.words = words;
        leftView = new HalfView(left, words, EDGE, HALVES_TOP);
        rightView = new HalfView(right, words, WIDTH - EDGE - HalfView.WIDTH, HALVES_TOP);
        List<String> titles =
                experiments.stream().map(experiment -> words.of(experiment.titleKey())).toList();
        bar = new ExperimentBar(titles, EDGE, EDGE, PLATE_WIDTH);
        plate = new DistancePlate(words, EDGE, CURVE_TOP, PLATE_WIDTH, HEIGHT - EDGE - CURVE_TOP);
        open(0);
    }

    private void open(int experiment) {
        chosen = experiment;
        room = Room.of(experiments.get(experiment));
        restart();
    }

    private void restart() {
        left.begin(room.copy());
        right.begin(room.copy());
        divergence = new Divergence();
    }

    Half left() {
        return left;
    }

    Half right() {
        return right;
    }

    Divergence divergence() {
        return divergence;
    }

    @Override
    public String title() {
        return "RigiBo – " + words.of("scene.laboratory");
    }

    @Override
    public void paced(double share) {
        pace = share;
    }

    @Override
    public void step() {
        if (!isPaused) {
            advance();
        }
    }

    /** The two halves take turns in going first, since the second one finds warm caches. */
    private void advance() {
        boolean isLeftFirst = turn++ % 2 == 0;
        (isLeftFirst ? left : right).step();
        (isLeftFirst ? right : left).step();
        divergence.step(left.pool(), right.pool());
    }

    @Override
    public void draw(Canvas canvas) {
        leftView.draw(canvas, room.skins());
        rightView.draw(canvas, room.skins());
        bar.draw(canvas, chosen);
        canvas.panel(EDGE, STATUS_TOP, PLATE_WIDTH, STATUS_HEIGHT, 12, Color.PANEL);
        double middle = STATUS_TOP + STATUS_HEIGHT / 2;
        text(canvas, ratio(), EDGE + 12, middle, Canvas.Align.LEFT, Color.TEXT);
        String state = isPaused ? words.of("badge.paused") : new Badge(words).pace(pace);
        text(canvas, state, WIDTH - EDGE - 12, middle, Canvas.Align.RIGHT, Color.BRASS);
        plate.draw(canvas, divergence, words.of(experiments.get(chosen).questionKey()));
    }

    private String ratio() {
        double one = left.medianMillis();
        double other = right.medianMillis();
        if (one == 0 || other == 0) {
            return words.of("laboratory.ask");
        }
        String times = String.format(Locale.ROOT, "%.2f", other / one);
        return words.of("laboratory.ratio", right.preset(), times, left.preset());
    }

    private static void text(
            Canvas canvas, String words, double x, double y, Canvas.Align align, Color color) {
        canvas.text(words, x, y, 16, Canvas.Font.WORDS, align, color);
    }

    @Override
    public void pointerMoved(double x, double y) {
        bar.pointerMoved(x, y);
        leftView.pointerMoved(x, y);
        rightView.pointerMoved(x, y);
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        if (button != PointerButton.LEFT) {
            return;
        }
        pointerMoved(x, y);
        leftView.pointerPressed(x, y);
        rightView.pointerPressed(x, y);
        if (bar.hot() >= 0) {
            open(bar.hot());
        }
    }

    @Override
    public Optional<Action.Place> place() {
        return Optional.of(Action.Place.DEMO);
    }

    @Override
    public void keyPressed(Key key) {
        switch (key) {
            case SPACE -> isPaused = !isPaused;
            case PERIOD -> advance();
            case R -> restart();
            case LEFT -> left.choose(left.preset().next());
            case RIGHT -> right.choose(right.preset().next());
            case DIGIT_1, DIGIT_2, DIGIT_3, DIGIT_4 -> open(key.ordinal() - Key.DIGIT_1.ordinal());
            default -> {}
        }
    }
}
