package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.widget.Sign;

import java.util.Optional;

/** Shows that a click was refused, and the reason. */
public final class Refusal {

    /** Time for which a refused object shakes. */
    private static final int SHAKING_TURNS = Steps.of(0.3);

    /** Time for which a refusal is shown: long enough to read its words. */
    private static final int SEEN_TURNS = Steps.of(1.2);

    private static final double SWING = 5;

    /** Half the width of the cross, px. */
    private static final double CROSS = 9;

    /** The reason of the present refusal. */
    private Optional<Reason> reason = Optional.empty();

    private double x;
    private double y;
    private int turnsLeft;

    /** Reasons for a refusal. */
    public enum Reason {
        COOLING_DOWN,
        NOT_CLICKABLE,
        NO_CLICKS_LEFT,
        NOTHING_THERE,
        /** There is nothing to undo. */
        NO_UNDO,
        NO_HINT_YET,
        /** No best run was kept that could be shown. */
        NO_RUN_YET,
        /** The game on the screen is not the player's own. */
        SHOWING,
        OVER
    }

    /** Refuses a click or command at a point of the screen, px. */
    void refuse(Reason why, double atX, double atY) {
        reason = Optional.of(why);
        x = atX;
        y = atY;
        turnsLeft = SEEN_TURNS;
    }

    /** Shows the result of a click at a point of the screen, px. */
    void answer(ClickResult result, double atX, double atY) {
        switch (result) {
            case DONE -> forget();
            case COOLING_DOWN -> refuse(Reason.COOLING_DOWN, atX, atY);
            case NOT_CLICKABLE -> refuse(Reason.NOT_CLICKABLE, atX, atY);
            case NO_CLICKS_LEFT -> refuse(Reason.NO_CLICKS_LEFT, atX, atY);
            case NOTHING_THERE -> refuse(Reason.NOTHING_THERE, atX, atY);
            case OVER -> refuse(Reason.OVER, atX, atY);
        }
    }

    void forget() {
        reason = Optional.empty();
    }

    /** After each frame. */
    void turn() {
        turnsLeft = Math.max(0, turnsLeft - 1);
        if (turnsLeft == 0) {
            forget();
        }
    }

    /** The present refusal. */
    public Optional<Reason> reason() {
        return reason;
    }

    public boolean is(Reason why) {
        return reason.filter(why::equals).isPresent();
    }

    /** Sideways displacement of the refused object, px; 0 if the player wants less motion. */
    public double shake(Motion motion) {
        int shaking = turnsLeft - (SEEN_TURNS - SHAKING_TURNS);
        boolean isStill = motion == Motion.REDUCED || reason.isEmpty() || shaking <= 0;
        return isStill ? 0 : SWING * Math.sin(1.4 * shaking);
    }

    /** Draws a small cross at the refused point. */
    void draw(Canvas canvas) {
        if (reason.isPresent()) {
            Sign.cross(canvas, x, y, CROSS + 2, 6, Color.DUSK_TOP);
            Sign.cross(canvas, x, y, CROSS, 3, Color.BAD);
        }
    }
}
