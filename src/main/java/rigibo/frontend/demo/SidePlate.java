package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.EnergyPlate;
import rigibo.frontend.scene.ghost.GhostPlate;

/**
 * The plate on the right, with the frame's time, the energy or the ghost. The ghost exists while
 * its side is shown.
 */
final class SidePlate {

    static final double WIDTH = StageProfile.WIDTH;

    private static final double TAB_HEIGHT = 24;

    /** Distance between two tabs, and between the tabs and what they show, px. */
    private static final double GAP = 4;

    private static final double TAB_WIDTH = (WIDTH - 2 * GAP) / 3;

    /** The sides, by the keys of the words on their tabs. */
    private enum Side {
        FRAME("side.frame"),
        ENERGY("side.energy"),
        GHOST("side.ghost");

        private final String key;

        Side(String key) {
            this.key = key;
        }
    }

    private final Workbench bench;
    private final double x;
    private final double y;
    private final Words words;
    private final StageProfile profile;
    private final EnergyPlate energy;
    private final GhostPlate ghost;
    private Side shown = Side.FRAME;
    private boolean wasWanted;

    /** Makes a plate with its upper left corner at (x, y), px, that shows its first side. */
    SidePlate(Workbench bench, Words words, double x, double y) {
        this.bench = bench;
        this.x = x;
        this.y = y;
        this.words = words;
        profile = new StageProfile(words);
        energy = new EnergyPlate(bench.pool(), words);
        ghost = new GhostPlate(words);
    }

    /** Returns a plate for another bench, so that a restarted scene shows the same side. */
    SidePlate of(Workbench other) {
        SidePlate next = new SidePlate(other, words, x, y);
        next.show(shown);
        return next;
    }

    void beforeStep() {
        energy.beforeStep();
    }

    void afterStep() {
        energy.afterStep();
        profile.step(bench.pool().report());
    }

    /** Records the time that drawing took, ns. */
    void drawn(long nanos) {
        profile.drawing(nanos);
    }

    void draw(Canvas canvas) {
        double below = y + TAB_HEIGHT + GAP;
        switch (shown) {
            case FRAME -> profile.draw(canvas, x, below);
            case ENERGY -> energy.draw(canvas, x, below, WIDTH);
            case GHOST -> ghost.draw(canvas, bench.ghost(), x, below, WIDTH);
        }
        for (Side side : Side.values()) {
            draw(canvas, side);
        }
    }

    private void draw(Canvas canvas, Side side) {
        boolean isLit = side == shown;
        Color plate = isLit ? Color.BRASS : Color.PANEL;
        canvas.panel(left(side), y, TAB_WIDTH, TAB_HEIGHT, 8, plate);
        canvas.text(
                words.of(side.key),
                left(side) + TAB_WIDTH / 2,
                y + TAB_HEIGHT / 2,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
    }

    private double left(Side side) {
        return x + side.ordinal() * (TAB_WIDTH + GAP);
    }

    /** Shows the next side. */
    void turnOver() {
        show(Side.values()[(shown.ordinal() + 1) % Side.values().length]);
    }

    /** Shows the ghost's side, or the first side if the ghost's is shown. */
    void turnToGhost() {
        show(shown == Side.GHOST ? Side.FRAME : Side.GHOST);
    }

    private void show(Side side) {
        shown = side;
        keepGhost();
    }

    /**
     * Shows the ghost's side when the demo begins to want it, and the first one when it no longer
     * does.
     */
    void keepGhost(boolean isWanted) {
        if (isWanted != wasWanted) {
            wasWanted = isWanted;
            show(isWanted ? Side.GHOST : Side.FRAME);
        }
        keepGhost();
    }

    /** Makes a ghost while its side is shown, at another accuracy than the scene's. */
    private void keepGhost() {
        bench.haunt(shown == Side.GHOST);
    }

    /** Handles a press of the pointer; returns whether it was on a tab. */
    boolean pointerPressed(double px, double py) {
        for (Side side : Side.values()) {
            boolean isBeside = px < left(side) || px > left(side) + TAB_WIDTH;
            if (!isBeside && py >= y && py <= y + TAB_HEIGHT) {
                show(side);
                return true;
            }
        }
        return false;
    }
}
