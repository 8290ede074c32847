package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.World;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.effects.CostMeter;
import rigibo.frontend.scene.effects.EffectsBar;
import rigibo.frontend.scene.effects.SceneEffects;
import rigibo.frontend.scene.trial.Trials;

/**
 * The effects bar of a level, behind a tab. While it is open the world moves down and gets smaller,
 * so that nothing of the play is covered; while it is shut nothing is measured.
 */
final class EffectsDrawer {

    /** Upper edge of the open bar, px: below the bar with title and clicks. */
    private static final double TOP = 62;

    /** Where the picture begins while the bar is open, px. */
    static final double FOOT = TOP + EffectsBar.HEIGHT + 8;

    private static final double TAB_TOP = 17;
    private static final double TAB_HEIGHT = 30;
    private static final double TAB_PADDING = 12;

    private final SceneEffects effects;
    private final Trials trials = Trials.inBackground();
    private final EffectsBar bar;
    private final World world;
    private final Camera camera;
    private boolean isOpen;
    private double tabLeft;
    private double tabWidth;

    EffectsDrawer(SceneEffects effects, World world, Camera camera) {
        this.effects = effects;
        this.world = world;
        this.camera = camera;
        bar = new EffectsBar(effects, new CostMeter(trials));
    }

    boolean isOpen() {
        return isOpen;
    }

    void toggle() {
        isOpen = !isOpen;
        double top = isOpen ? FOOT : 0;
        double room = Scene.HEIGHT - top;
        double scale = Math.min(Scene.WIDTH / world.width(), room / world.height());
        double middle = top + room / 2;
        double aside = (middle - Scene.HEIGHT / 2.0) / scale;
        camera.look(world.width() / 2, world.height() / 2 + aside, scale);
    }

    /** Draws the tab with its left edge at x, and the bar where it is open. */
    void draw(Canvas canvas, double x) {
        boolean isExperiment = !effects.marking().isEmpty();
        String words = isExperiment ? "experiment" : "effects (E)";
        tabLeft = x;
        tabWidth = canvas.textWidth(words, 16, Canvas.Font.WORDS) + 2 * TAB_PADDING;
        double corner = TAB_HEIGHT / 2;
        Color plate = isOpen ? Color.BRASS : Color.PANEL_LIT;
        canvas.panel(x, TAB_TOP, tabWidth, TAB_HEIGHT, corner, plate);
        if (isExperiment) {
            canvas.frame(x, TAB_TOP, tabWidth, TAB_HEIGHT, corner, Color.BAD);
        }
        canvas.text(
                words,
                x + tabWidth / 2,
                TAB_TOP + TAB_HEIGHT / 2,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                isOpen ? Color.DUSK_TOP : Color.TEXT);
        if (isOpen) {
            bar.draw(canvas, TOP);
        }
    }

    void drawn() {
        if (isOpen) {
            bar.turn();
        }
    }

    void close() {
        trials.close();
    }

    void pointerMoved(double x, double y) {
        bar.pointerMoved(x, y);
    }

    /** The pointer went down; returns whether on the tab or the open bar. */
    boolean pointerPressed(double x, double y) {
        boolean isOnTab =
                x >= tabLeft
                        && x <= tabLeft + tabWidth
                        && y >= TAB_TOP
                        && y <= TAB_TOP + TAB_HEIGHT;
        if (isOnTab) {
            toggle();
        }
        return isOnTab || isOpen && bar.pointerPressed(x, y);
    }
}
