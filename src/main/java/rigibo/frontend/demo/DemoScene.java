package rigibo.frontend.demo;

import rigibo.backend.geometry.Logarithm;
import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Grip;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.AccuracyLink;
import rigibo.frontend.scene.accuracy.AccuracyMeter;
import rigibo.frontend.scene.effects.CostMeter;
import rigibo.frontend.scene.trial.Trials;
import rigibo.frontend.scene.widget.HandButtons;
import rigibo.frontend.scene.widget.WholePlate;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * A demo on its workbench, with its panel, accuracy bar, effects bar, step time and the shared
 * keys.
 */
final class DemoScene implements Scene {

    private static final String TITLE = "RigiBo – ";

    private static final double ZOOM = 1.15;

    /** Where the legend of the debug drawing stands, above the plates at the foot, px. */
    private static final double LEGEND_LEFT = 8;

    private static final double LEGEND_ABOVE = 60;

    private final Director director;
    private final Function<Words, Demo> maker;
    private Demo demo;
    private Workbench bench;
    private DemoPlates plates;
    private Choices choices;
    private final Trials trials = Trials.inBackground();
    private final CostMeter costs = new CostMeter(trials);
    private final AccuracyMeter errors = new AccuracyMeter(trials);
    private final WholePlate whole;
    private boolean isPaused;
    private boolean isDebugging;
    private HelpSheet help = HelpSheet.CLOSED;
    private boolean isPanning;

    /** Whether the view began in an upright window in a hand. */
    private boolean isUpright;

    private double lastX;
    private double lastY;

    DemoScene(Director director, Function<Words, Demo> maker) {
        this.director = director;
        this.maker = maker;
        whole = new WholePlate(director.words());
        restart();
    }

    private void restart() {
        demo = maker.apply(director.words());
        Camera camera = demo.camera();
        if (bench != null) {
            bench.close();
        }
        bench = new Workbench(demo.effects(), camera);
        isUpright = false;
        demo.build(bench);
        choices = new Choices(demo.widgets());
        plates =
                plates == null
                        ? new DemoPlates(demo, bench, director.words(), errors, costs)
                        : plates.of(demo, bench, director.words(), errors, costs);
    }

    @Override
    public String title() {
        return TITLE + director.words().of("scene." + demo.name());
    }

    @Override
    public Link link() {
        Link accurate = AccuracyLink.in(Link.to(demo.name()), bench.pool());
        return choices.in(plates.isGhostOpen() ? accurate.withGhost() : accurate);
    }

    @Override
    public boolean follow(Link link) {
        int taken = choices.follow(link);
        if (taken > 0) {
            demo.followed();
        }
        taken += AccuracyLink.follow(link, bench.pool());
        if (link.hasGhost()) {
            plates.openGhost();
            taken++;
        }
        return taken == link.choices().size();
    }

    @Override
    public boolean hasColumns() {
        return true;
    }

    @Override
    public boolean isForHands() {
        return true;
    }

    /** The buttons of a hand. */
    private List<HandButtons.Item> buttons() {
        Words words = director.words();
        HandButtons.Item leave =
                new HandButtons.Item(words.of("puzzle.command.menu"), director::showMenu);
        return HandButtons.ofSeveral(
                words, leave, isPaused, this::pause, this::showBeside, this::restart);
    }

    private void pause() {
        isPaused = !isPaused;
    }

    private void showBeside(int direction) {
        director.show(Demos.beside(demo.name(), direction, director));
    }

    @Override
    public Tap tap(double x, double y) {
        if (plates.contain(x, y)) {
            return plates.tap(x, y);
        }
        if (whole.contains(x, y)) {
            return Tap.LIFTED;
        }
        Camera camera = bench.camera();
        return Grip.tap(bench.pool(), camera.worldX(x), camera.worldY(y));
    }

    @Override
    public void step() {
        if (!isPaused) {
            advance();
        }
    }

    private void advance() {
        plates.wantGhost(demo.wantsGhost());
        bench.pull();
        demo.beforeStep(bench);
        plates.beforeStep();
        bench.step(STEP);
        bench.tell(director.sounds());
        plates.afterStep();
        demo.afterStep(bench);
    }

    @Override
    public void draw(Canvas canvas) {
        turn(canvas.layout());
        bench.draw(canvas);
        if (isDebugging) {
            bench.drawDebug(canvas, STEP);
        }
        demo.draw(bench, canvas);
        whole.hide();
        if (bench.camera().isPinched()) {
            whole.draw(canvas, HEIGHT);
        }
        plates.draw(canvas, isPaused, buttons(), HandButtons.ofAddress(director));
        if (!canvas.layout().isInHand()) {
            drawNotes(canvas);
        }
    }

    /** Begins the view anew where a hand has turned the window. */
    private void turn(Layout layout) {
        boolean isUprightNow = layout.isInHand() && layout.isUpright();
        if (isUprightNow != isUpright) {
            isUpright = isUprightNow;
            bench.camera().begin(isUpright ? demo.cameraUpright() : demo.camera());
        }
    }

    @Override
    public void describe(Narrator narrator) {
        plates.describe(narrator);
        whole.describe(narrator);
        if (isPaused) {
            narrator.says(director.words().of("badge.paused"));
        }
    }

    /** Draws the legend and the help that keys open; a handheld window has no keys. */
    private void drawNotes(Canvas canvas) {
        if (isDebugging) {
            DebugLegend.draw(canvas, director.words(), LEGEND_LEFT, HEIGHT - LEGEND_ABOVE);
        }
        help.draw(director.words(), demo.name(), bench.pool().plan(), canvas);
    }

    @Override
    public void drawn(long nanos) {
        plates.drawn(nanos);
        demo.drawn(nanos);
    }

    @Override
    public void paced(double share) {
        plates.paced(share);
    }

    @Override
    public void closed() {
        trials.close();
        bench.close();
    }

    @Override
    public void pointerMoved(double x, double y) {
        plates.pointerMoved(x, y);
        if (isPanning) {
            bench.camera().pan(x - lastX, y - lastY);
        }
        lastX = x;
        lastY = y;
        bench.point(bench.camera().worldX(x), bench.camera().worldY(y));
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        pointerMoved(x, y);
        Optional<HandButtons.Item> pressed = plates.button(x, y);
        if (button == PointerButton.LEFT && pressed.isPresent()) {
            pressed.get().action().run();
        } else if (button == PointerButton.LEFT && !plates.pointerPressed(x, y)) {
            grabOrShowAll(x, y);
        } else if (button == PointerButton.RIGHT && !plates.contain(x, y)) {
            isPanning = true;
            demo.rightClick(bench, bench.pointerX(), bench.pointerY());
        }
    }

    private void grabOrShowAll(double x, double y) {
        if (whole.contains(x, y)) {
            bench.camera().home();
        } else {
            bench.grab(bench.pointerX(), bench.pointerY());
        }
    }

    @Override
    public void pinched(Pinch pinch) {
        bench.camera().pinch(pinch);
    }

    @Override
    public void pointerReleased(PointerButton button, double x, double y) {
        plates.pointerReleased();
        bench.letGo();
        isPanning = false;
    }

    @Override
    public void scrolled(double notches, double x, double y) {
        bench.camera().zoom(Logarithm.pow(ZOOM, notches), x, y);
    }

    @Override
    public Optional<Action.Place> place() {
        return Optional.of(Action.Place.DEMO);
    }

    @Override
    public boolean escaped() {
        boolean isHelping = help != HelpSheet.CLOSED;
        help = HelpSheet.CLOSED;
        return isHelping;
    }

    @Override
    public void keyPressed(Key key) {
        if (plates.keyPressed(key)) {
            return;
        }
        switch (key) {
            case SPACE -> pause();
            case PERIOD -> advance();
            case R -> restart();
            case HOME -> bench.camera().home();
            case D -> isDebugging = !isDebugging;
            case LEFT_BRACKET -> showBeside(-1);
            case RIGHT_BRACKET -> showBeside(1);
            case F1, H -> help = help.next();
            default -> demo.key(bench, key);
        }
    }
}
