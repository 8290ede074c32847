package rigibo.frontend.demo;

import rigibo.backend.effect.Effect;
import rigibo.backend.setup.StepStage;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Panel;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** A demo on its workbench: the panel, the effects bar, the step's time, and the shared keys. */
final class DemoScene implements Scene {

    private static final double STEP = 1.0 / 60;
    private static final double PANEL_WIDTH = 270;
    private static final double BUDGET_MILLIS = 1000.0 / 60;
    private static final double ZOOM = 1.15;

    private final Supplier<Demo> maker;
    private Demo demo;
    private Workbench bench;
    private Panel panel;
    private boolean isPaused;
    private boolean isDebugging;
    private boolean isHelping;
    private boolean isPanning;
    private double lastX;
    private double lastY;
    private double stepMillis;

    DemoScene(Supplier<Demo> maker) {
        this.maker = maker;
        restart();
    }

    private void restart() {
        demo = maker.get();
        Camera camera = demo.camera();
        bench = new Workbench(demo.effects(), camera);
        demo.build(bench);
        panel = new Panel(8, 8, PANEL_WIDTH, demo.widgets());
    }

    @Override
    public String title() {
        return "RigiBo – " + demo.title();
    }

    @Override
    public void step() {
        if (!isPaused) {
            advance();
        }
    }

    private void advance() {
        bench.pull();
        demo.beforeStep(bench);
        bench.pool().step(STEP);
        demo.afterStep(bench);
        long nanos = 0;
        for (StepStage stage : StepStage.values()) {
            nanos += bench.pool().report().nanos(stage);
        }
        stepMillis += (nanos / 1e6 - stepMillis) / 15;
    }

    @Override
    public void draw(Canvas canvas) {
        bench.draw(canvas);
        if (isDebugging) {
            bench.drawDebug(canvas);
        }
        demo.draw(bench, canvas);
        panel.draw(canvas);
        drawTime(canvas);
        drawEffects(canvas);
        if (isHelping) {
            drawHelp(canvas);
        }
    }

    /** The step's time against the 16.7 ms of a frame. */
    private void drawTime(Canvas canvas) {
        double x = WIDTH - 214;
        canvas.panel(x, 8, 206, 56, 12, Color.PANEL);
        String words =
                isPaused
                        ? "paused"
                        : String.format(java.util.Locale.ROOT, "step %.2f ms", stepMillis);
        canvas.text(words, x + 12, 26, 16, Canvas.Font.NUMBERS, Canvas.Align.LEFT, Color.TEXT);
        double share = Math.min(1, stepMillis / BUDGET_MILLIS);
        canvas.panel(x + 12, 42, 182, 8, 4, Color.PANEL_LIT);
        canvas.panel(
                x + 12, 42, Math.max(8, 182 * share), 8, 4, share < 1 ? Color.GOOD : Color.BAD);
    }

    /** What is simulated here, by name; what is not declared is not there. */
    private void drawEffects(Canvas canvas) {
        List<String> lines = lines(canvas);
        double height = 22 * lines.size() + 14;
        double top = HEIGHT - 8 - height;
        canvas.panel(8, top, WIDTH - 16, height, 12, Color.PANEL);
        for (int i = 0; i < lines.size(); i++) {
            canvas.text(
                    lines.get(i),
                    20,
                    top + 18 + 22 * i,
                    16,
                    Canvas.Font.WORDS,
                    Canvas.Align.LEFT,
                    Color.BRASS);
        }
    }

    private List<String> lines(Canvas canvas) {
        List<String> lines = new ArrayList<>();
        StringBuilder line = new StringBuilder("simulated:");
        for (Effect effect : bench.pool().effects().all()) {
            String word = "  " + effect.title();
            if (canvas.textWidth(line + word, 16, Canvas.Font.WORDS) > WIDTH - 130) {
                lines.add(line.toString());
                line = new StringBuilder();
            }
            line.append(word);
        }
        lines.add(line + "   (F1: keys)");
        return lines;
    }

    private static void drawHelp(Canvas canvas) {
        String[] rows = {
            "drag a body, let go to fling it",
            "Space  pause      .  one step",
            "R  restart        D  debug drawing",
            "wheel zoom, right drag pan, Home",
            "Esc back to the menu"
        };
        // A veil over everything: words would shine through a panel.
        canvas.panel(0, 0, WIDTH, HEIGHT, 0, Color.DUSK_TOP.alpha(0.96));
        for (int i = 0; i < rows.length; i++) {
            canvas.text(
                    rows[i],
                    WIDTH / 2.0,
                    334 + 28 * i,
                    18,
                    Canvas.Font.WORDS,
                    Canvas.Align.CENTRE,
                    Color.TEXT);
        }
    }

    @Override
    public void pointerMoved(double x, double y) {
        panel.pointerMoved(x, y);
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
        if (button == PointerButton.LEFT && !panel.pointerPressed(x, y)) {
            bench.grab(bench.pointerX(), bench.pointerY());
        } else if (button == PointerButton.RIGHT && !panel.contains(x, y)) {
            isPanning = true;
            demo.rightClick(bench, bench.pointerX(), bench.pointerY());
        }
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
            case F1, H -> isHelping = !isHelping;
            default -> demo.key(bench, key);
        }
    }
}
