package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.effects.CostMeter;
import rigibo.frontend.scene.effects.EffectsBar;
import rigibo.frontend.scene.effects.SceneEffects;
import rigibo.frontend.scene.trial.Trials;

/** The effects bar of a level, above or beside the play. While closed it measures nothing. */
final class EffectsDrawer {

    private static final double LEFT = 8;

    /** Upper edge of the open bar, px: below the bar with title and clicks. */
    private static final double TOP = View.BAR_FOOT + 6;

    /** Gap below the open bar, px. */
    private static final double GAP = 8;

    private final Trials trials = Trials.inBackground();
    private final EffectsBar bar;

    EffectsDrawer(SceneEffects effects) {
        bar = new EffectsBar(effects, new CostMeter(trials));
    }

    /** Upper edge of the play below the open bar, px. */
    static double foot(Layout layout) {
        return TOP + EffectsBar.height(layout) + GAP;
    }

    /** Draws the bar beside the play, in the right column. */
    void drawBeside(Canvas canvas) {
        Layout layout = canvas.layout();
        bar.draw(canvas, layout.rightColumn(), LEFT, layout.columnWidth());
    }

    /** Whether a point lies on the bar as it was last drawn. */
    boolean contains(double x, double y) {
        return bar.contains(x, y);
    }

    /** Draws the bar above the play. */
    void draw(Canvas canvas) {
        bar.draw(canvas, LEFT, TOP, Scene.WIDTH - 2 * LEFT);
    }

    /** Called after each frame that shows it. */
    void drawn() {
        bar.turn();
    }

    void close() {
        trials.close();
    }

    void pointerMoved(double x, double y) {
        bar.pointerMoved(x, y);
    }

    void pointerPressed(double x, double y) {
        bar.pointerPressed(x, y);
    }
}
