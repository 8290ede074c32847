package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Badge;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.ghost.Divergence;
import rigibo.frontend.scene.widget.Plate;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Two accuracies side by side, started from the same state, in real time or as near to it as
 * possible; below them what is graphed of the two, or the sliders of their accuracies.
 */
final class LaboratoryScene implements Scene {

    private static final double EDGE = 8;
    private static final double PLATE_WIDTH = WIDTH - 2 * EDGE;
    private static final double HALVES_TOP = EDGE + ButtonBar.HEIGHT + 6;
    private static final double STATUS_TOP = HALVES_TOP + HalfView.HEIGHT + 6;
    private static final double STATUS_HEIGHT = 34;
    private static final double DRAWERS_TOP = STATUS_TOP + STATUS_HEIGHT + 6;
    private static final double CURVE_TOP = DRAWERS_TOP + ButtonBar.HEIGHT + 6;

    /** What the buttons below open or do, after one for each quantity. */
    private static final int EXPERT = Quantity.values().length;

    private static final int TABLE = EXPERT + 1;
    private static final int PICTURE = EXPERT + 2;

    private final Words words;
    private final Keeping keeping;
    private final List<Experiment> experiments = Experiments.all();
    private final Half left = new Half(Preset.DRAFT);
    private final Half right = new Half(Preset.EXACT);
    private final HalfView leftView;
    private final HalfView rightView;
    private final ButtonBar bar;
    private final ButtonBar drawers;
    private final GraphPlate plate;
    private final ExpertPlate expert;
    private Room room;
    private Divergence divergence;
    private Log log;
    private int chosen;

    /** The quantity that is graphed, or the sliders. */
    private int drawer;

    /** Share of real time at which the loop runs. */
    private double pace = 1;

    private int turn;
    private boolean isPaused;

    LaboratoryScene(Director director) {
        words = director.words();
        keeping = new Keeping(director);
        leftView = new HalfView(left, words, EDGE, HALVES_TOP);
        rightView = new HalfView(right, words, WIDTH - EDGE - HalfView.WIDTH, HALVES_TOP);
        List<String> titles =
                experiments.stream().map(experiment -> words.of(experiment.titleKey())).toList();
        bar = new ButtonBar(titles, EDGE, EDGE, PLATE_WIDTH);
        drawers = new ButtonBar(drawerTitles(), EDGE, DRAWERS_TOP, PLATE_WIDTH);
        Plate below = new Plate(EDGE, CURVE_TOP, PLATE_WIDTH, HEIGHT - EDGE - CURVE_TOP);
        plate = new GraphPlate(words, below);
        expert = new ExpertPlate(words, below, left, right);
        open(0);
    }

    private List<String> drawerTitles() {
        List<String> titles = new ArrayList<>();
        for (Quantity quantity : Quantity.values()) {
            titles.add(words.of(quantity.key()));
        }
        for (String key : List.of("expert", "table", "picture")) {
            titles.add(words.of("laboratory." + key));
        }
        return titles;
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
        log = new Log();
        keeping.forget();
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
        log.add(left, right, divergence.distance());
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
        drawers.draw(canvas, drawer);
        if (drawer == EXPERT) {
            expert.draw(canvas);
        } else if (Quantity.values()[drawer] == Quantity.DISTANCE) {
            plate.drawDistance(canvas, divergence, note());
        } else {
            plate.draw(canvas, log, Quantity.values()[drawer], note());
        }
    }

    private String note() {
        return keeping.told().isEmpty()
                ? words.of(experiments.get(chosen).questionKey())
                : keeping.told();
    }

    private void press(int button) {
        String name = experiments.get(chosen).name();
        if (button == TABLE) {
            keeping.table(name, log.table(about()));
        } else if (button == PICTURE) {
            keeping.picture(name);
        } else {
            drawer = button;
        }
    }

    /** What was measured, for whoever reads the table; not translated, like its columns. */
    private String about() {
        return experiments.get(chosen).name()
                + "; left: "
                + left.accuracy()
                + "; right: "
                + right.accuracy();
    }

    private String ratio() {
        double one = left.medianMillis();
        double other = right.medianMillis();
        if (one == 0 || other == 0) {
            return words.of("laboratory.ask");
        }
        String times = words.number("%.2f", other / one);
        return words.of("laboratory.ratio", rightView.name(), times, leftView.name());
    }

    private static void text(
            Canvas canvas, String words, double x, double y, Canvas.Align align, Color color) {
        canvas.text(words, x, y, 16, Canvas.Font.WORDS, align, color);
    }

    @Override
    public void pointerMoved(double x, double y) {
        bar.pointerMoved(x, y);
        drawers.pointerMoved(x, y);
        if (drawer == EXPERT) {
            expert.pointerMoved(x, y);
        }
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
        if (drawer == EXPERT) {
            expert.pointerPressed(x, y);
        }
        if (bar.hot() >= 0) {
            open(bar.hot());
        }
        if (drawers.hot() >= 0) {
            press(drawers.hot());
        }
    }

    @Override
    public void pointerReleased(PointerButton button, double x, double y) {
        expert.pointerReleased();
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
            case G -> drawer = (drawer + 1) % Quantity.values().length;
            case X -> drawer = EXPERT;
            case C -> press(TABLE);
            case I -> press(PICTURE);
            case DIGIT_1, DIGIT_2, DIGIT_3, DIGIT_4 -> open(key.ordinal() - Key.DIGIT_1.ordinal());
            default -> {}
        }
    }
}
