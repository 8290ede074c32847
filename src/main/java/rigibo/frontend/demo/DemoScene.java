package rigibo.frontend.demo;

import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.AccuracyBar;
import rigibo.frontend.scene.accuracy.AccuracyMeter;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.effects.CostMeter;
import rigibo.frontend.scene.effects.EffectsBar;
import rigibo.frontend.scene.trial.Trials;
import rigibo.frontend.scene.widget.Panel;

import java.util.function.Function;

/**
 * A demo on its workbench, with its panel, accuracy bar, effects bar, step time and the shared
 * keys.
 */
final class DemoScene implements Scene {

    static final String TITLE = "RigiBo – ";

    private static final double PANEL_WIDTH = 270;
    private static final double TOP = 8;
    private static final double BELOW_BAR = TOP + AccuracyBar.HEIGHT + 6;
    private static final double RIGHT = WIDTH - 8 - SidePlate.WIDTH;
    private static final double ZOOM = 1.15;

    private final Director director;
    private final Function<Words, Demo> maker;
    private Demo demo;
    private Workbench bench;
    private Panel panel;
    private SidePlate side;
    private AccuracyBar accuracy;
    private final Trials trials = Trials.inBackground();
    private final CostMeter costs = new CostMeter(trials);
    private final AccuracyMeter errors = new AccuracyMeter(trials);
    private EffectsBar effects;
    private boolean isPaused;
    private boolean isDebugging;
    private boolean isHelping;
    private boolean isPanning;
    private double lastX;
    private double lastY;

    DemoScene(Director director, Function<Words, Demo> maker) {
        this.director = director;
        this.maker = maker;
        restart();
    }

    private void restart() {
        demo = maker.apply(director.words());
        Camera camera = demo.camera();
        bench = new Workbench(demo.effects(), camera);
        demo.build(bench);
        panel = new Panel(8, BELOW_BAR, PANEL_WIDTH, demo.widgets());
        side =
                side == null
                        ? new SidePlate(bench, director.words(), RIGHT, BELOW_BAR)
                        : side.of(bench);
        accuracy = new AccuracyBar(bench.pool(), errors, director.words(), TOP);
        effects = new EffectsBar(new DemoEffects(demo, bench, director.words()), costs);
    }

    @Override
    public String title() {
        return TITLE + demo.title();
    }

    @Override
    public void step() {
        if (!isPaused) {
            advance();
        }
    }

    private void advance() {
        side.keepGhost(demo.wantsGhost());
        bench.pull();
        demo.beforeStep(bench);
        side.beforeStep();
        bench.step(STEP);
        bench.tell(director.sounds());
        side.afterStep();
        accuracy.stepped();
        demo.afterStep(bench);
    }

    @Override
    public void draw(Canvas canvas) {
        bench.draw(canvas);
        if (isDebugging) {
            bench.drawDebug(canvas, STEP);
        }
        demo.draw(bench, canvas);
        panel.draw(canvas);
        accuracy.draw(canvas, isPaused);
        effects.draw(canvas, HEIGHT - 8 - EffectsBar.HEIGHT);
        side.draw(canvas);
        if (isHelping) {
            HelpSheet.draw(director.words(), bench.pool().plan(), canvas);
        }
    }

    @Override
    public void drawn(long nanos) {
        side.drawn(nanos);
        demo.drawn(nanos);
        effects.turn();
        accuracy.turn();
    }

    @Override
    public void paced(double share) {
        accuracy.paced(share);
    }

    @Override
    public void closed() {
        trials.close();
    }

    @Override
    public void pointerMoved(double x, double y) {
        panel.pointerMoved(x, y);
        accuracy.pointerMoved(x, y);
        effects.pointerMoved(x, y);
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
        if (button == PointerButton.LEFT && !pressesControl(x, y)) {
            bench.grab(bench.pointerX(), bench.pointerY());
        } else if (button == PointerButton.RIGHT && !panel.contains(x, y)) {
            isPanning = true;
            demo.rightClick(bench, bench.pointerX(), bench.pointerY());
        }
    }

    private boolean pressesControl(double x, double y) {
        return panel.pointerPressed(x, y)
                || accuracy.pointerPressed(x, y)
                || side.pointerPressed(x, y)
                || effects.pointerPressed(x, y);
    }

    @Override
    public void pointerReleased(PointerButton button, double x, double y) {
        panel.pointerReleased();
        bench.letGo();
        isPanning = false;
    }

    @Override
    public void scrolled(double notches, double x, double y) {
        bench.camera().zoom(Math.pow(ZOOM, notches), x, y);
    }

    @Override
    public void keyPressed(Key key) {
        if (panel.keyPressed(key)) {
            return;
        }
        switch (key) {
            case SPACE -> isPaused = !isPaused;
            case PERIOD -> advance();
            case R -> restart();
            case HOME -> bench.camera().home();
            case D -> isDebugging = !isDebugging;
            case LEFT_BRACKET -> director.show(Demos.beside(title(), -1, director));
            case RIGHT_BRACKET -> director.show(Demos.beside(title(), 1, director));
            case DIGIT_1, DIGIT_2, DIGIT_3, DIGIT_4 ->
                    accuracy.choose(Preset.values()[key.ordinal() - Key.DIGIT_1.ordinal()]);
            case N -> side.turnOver();
            case G -> side.turnToGhost();
            case F1, H -> isHelping = !isHelping;
            default -> demo.key(bench, key);
        }
    }
}
