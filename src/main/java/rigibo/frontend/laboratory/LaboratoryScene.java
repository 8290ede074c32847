package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.ghost.Divergence;
import rigibo.frontend.scene.widget.Plate;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Two accuracies side by side, started from the same state, in real time or as near to it as
 * possible. Below them is a graph of both, or the sliders of their accuracies.
 */
final class LaboratoryScene implements Scene {

    static final String NAME = "laboratory";

    private static final String EXPERIMENT = "experiment";
    private static final String GRAPH = "graph";

    /** Numbers of the buttons below; those of the quantities come first. */
    private static final int EXPERT = Quantity.values().length;

    private static final int TABLE = EXPERT + 1;
    private static final int PICTURE = EXPERT + 2;

    /** The commands of a hand. */
    private static final int MENU = 0;

    private static final int PAUSE = 1;
    private static final int RESTART = 2;
    private static final int NO_COMMAND = -1;

    private final Director director;
    private final Words words;
    private final Keeping keeping;
    private final List<Experiment> experiments = Experiments.all();
    private final Half left = new Half(Preset.DRAFT);
    private final Half right = new Half(Preset.EXACT);
    private final HalfView leftView;
    private final HalfView rightView;
    private final StatusPlate status;
    private final ButtonBar bar;
    private final ButtonBar drawers;

    /** The buttons of a handheld window: the graphs alone, and commands in place of keys. */
    private final ButtonBar graphs;

    private final ButtonBar commands;
    private boolean isInHand;
    private final GraphPlate plate;
    private final ExpertPlate expert;

    /** The link to the laboratory as it begins. */
    private final Link first;

    private Room room;
    private Divergence divergence;
    private Log log;
    private int chosen;

    /** The quantity that is graphed, or the sliders. */
    private int drawer;

    private int turn;
    private boolean isPaused;

    LaboratoryScene(Director director) {
        words = director.words();
        keeping = new Keeping(director);
        this.director = director;
        leftView = new HalfView(left, words);
        rightView = new HalfView(right, words);
        status = new StatusPlate(words, leftView, rightView);
        List<String> titles =
                experiments.stream().map(experiment -> words.of(experiment.titleKey())).toList();
        bar = new ButtonBar(titles);
        drawers = new ButtonBar(drawerTitles());
        graphs = new ButtonBar(drawerTitles().subList(0, EXPERT));
        commands = new ButtonBar(Stream.of("menu", "pause", "restart").map(this::command).toList());
        plate = new GraphPlate(words);
        expert = new ExpertPlate(words, LaboratoryPlaces.ON_A_DESK.graph(), left, right);
        open(0);
        first = whole();
    }

    /**
     * The link states all choices or none, so that a choice that was set back to its default is
     * stated too.
     */
    @Override
    public Link link() {
        Link whole = whole();
        return whole.equals(first) ? Link.to(NAME) : whole;
    }

    private Link whole() {
        Link link = Link.to(NAME).with(EXPERIMENT, experiments.get(chosen).name());
        for (LinkedHalf half : expert.halves()) {
            link = half.in(link);
        }
        return link.with(GRAPH, linked(drawer));
    }

    @Override
    public boolean follow(Link link) {
        int taken = 0;
        for (int i = 0; i < experiments.size(); i++) {
            if (experiments.get(i).name().equals(link.choices().get(EXPERIMENT))) {
                open(i);
                taken++;
            }
        }
        for (LinkedHalf half : expert.halves()) {
            taken += half.follow(link);
        }
        for (int i = 0; i <= EXPERT; i++) {
            if (linked(i).equals(link.choices().get(GRAPH))) {
                drawer = i;
                taken++;
            }
        }
        return taken == link.choices().size();
    }

    /** The name in links of a graph, or of the sliders. */
    private static String linked(int drawer) {
        return drawer == EXPERT ? "expert" : Quantity.values()[drawer].linked();
    }

    private String command(String name) {
        return words.of("puzzle.command." + name);
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
        status.paced(share);
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
    public boolean isSheet() {
        return true;
    }

    @Override
    public Tap tap(double x, double y) {
        return Tap.LIFTED;
    }

    @Override
    public void draw(Canvas canvas) {
        LaboratoryPlaces places = LaboratoryPlaces.of(canvas.layout());
        isInHand = canvas.layout().isInHand();
        leftView.draw(canvas, places.left(), room.skins());
        rightView.draw(canvas, places.right(), room.skins());
        bar.draw(canvas, places.experiments(), places.rows(), chosen);
        if (isInHand) {
            // There is no room for sliders side by side, and files need a larger window.
            drawer = drawer < EXPERT ? drawer : 0;
            commands.draw(canvas, places.commands(), 1, isPaused ? PAUSE : NO_COMMAND);
            graphs.draw(canvas, places.drawers(), 1, drawer);
            status.drawInHand(canvas, places.status(), isPaused);
        } else {
            drawers.draw(canvas, places.drawers(), 1, drawer);
            status.draw(canvas, places.status(), isPaused);
        }
        drawDrawer(canvas, places.graph());
    }

    /** How much dearer one half is changes all the time, and is not said. */
    @Override
    public void describe(Narrator narrator) {
        if (isInHand) {
            commands.describe(narrator, isPaused ? PAUSE : NO_COMMAND);
        }
        bar.describe(narrator, chosen);
        leftView.describe(narrator, "laboratory.left");
        rightView.describe(narrator, "laboratory.right");
        below().describe(narrator, drawer);
        narrator.says(note());
        if (isPaused) {
            narrator.says(words.of("badge.paused"));
        }
    }

    private void drawDrawer(Canvas canvas, Plate at) {
        plate.place(at);
        if (drawer == EXPERT) {
            expert.draw(canvas);
        } else if (Quantity.values()[drawer] == Quantity.DISTANCE) {
            boolean isNew = !keeping.told().isEmpty();
            plate.drawDistance(canvas, divergence, isNew ? Optional.of(note()) : parting(), note());
        } else {
            plate.draw(canvas, log, Quantity.values()[drawer], note());
        }
    }

    private String note() {
        return keeping.told().isEmpty()
                ? words.of(experiments.get(chosen).questionKey())
                : keeping.told();
    }

    private Optional<String> parting() {
        return divergence.parting().map(parting -> parting.in(words));
    }

    private void press(int button) {
        String name = experiments.get(chosen).name();
        if (button > EXPERT && drawer == EXPERT) {
            // Below a graph is told where the file is; beside the sliders is no room for that.
            drawer = Quantity.DISTANCE.ordinal();
        }
        if (button == TABLE) {
            keeping.table(name, log.table(about()));
        } else if (button == PICTURE) {
            keeping.picture(name);
        } else {
            drawer = button;
        }
    }

    /** The table's description, which is not translated, like its columns. */
    private String about() {
        return experiments.get(chosen).name()
                + "; left: "
                + left.accuracy()
                + "; right: "
                + right.accuracy();
    }

    @Override
    public void pointerMoved(double x, double y) {
        bar.pointerMoved(x, y);
        below().pointerMoved(x, y);
        commands.pointerMoved(x, y);
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
        if (below().hot() >= 0) {
            press(below().hot());
        }
        if (isInHand) {
            follow(commands.hot());
        }
    }

    /** The bar of buttons below the halves. */
    private ButtonBar below() {
        return isInHand ? graphs : drawers;
    }

    private void follow(int button) {
        switch (button) {
            case MENU -> director.showMenu();
            case PAUSE -> isPaused = !isPaused;
            case RESTART -> restart();
            default -> {}
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
