package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Enlarged;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.AccuracyBar;
import rigibo.frontend.scene.accuracy.AccuracyMeter;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.effects.CostMeter;
import rigibo.frontend.scene.effects.EffectsBar;
import rigibo.frontend.scene.widget.HandButtons;
import rigibo.frontend.scene.widget.HandFrame;
import rigibo.frontend.scene.widget.Plate;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * The plates of a demo: accuracy, controls, effects, and one at the side. They stand beside the
 * scene where the window is wide enough; otherwise they lie over it, folded to their tabs until
 * they are opened. A key hides and shows them all.
 */
final class DemoPlates {

    private static final double EDGE = 8;

    /** Between plates, px. */
    private static final double GAP = 6;

    /** Widest controls, px: demos draw their world to the right of them. */
    private static final double WIDEST_CONTROLS = 294;

    /** Width over the scene with text of its usual size, px. */
    private static final double SIDE_WIDTH = 240;

    /** Which plates are open; kept when the demo is restarted. */
    private final Folds folds;

    private final int mostColumns;
    private final Workbench bench;
    private final DemoControls controls;
    private final SidePlate side;
    private final AccuracyBar accuracy;
    private final EffectsBar effects;
    private final Tabs tabs;
    private final HandButtons buttons = new HandButtons();

    /** The canvas of the plates in a handheld window. */
    private Optional<Enlarged> inHand = Optional.empty();

    private Plate sidePlace = Plate.NONE;
    private boolean isHidden;
    private boolean wasGhostWanted;

    private DemoPlates(
            Demo demo,
            Workbench bench,
            Words words,
            AccuracyMeter errors,
            CostMeter costs,
            Folds folds) {
        this.bench = bench;
        this.folds = folds;
        mostColumns = demo.goesOnToTheRight() ? 1 : 2;
        controls = new DemoControls(demo.widgets());
        side = new SidePlate(bench, words);
        accuracy = new AccuracyBar(bench.pool(), errors, words);
        effects = new EffectsBar(new DemoEffects(demo, bench, words), costs);
        tabs = new Tabs(words, folds);
    }

    /** The plates of a demo that was built on a bench, with errors and costs from meters. */
    DemoPlates(Demo demo, Workbench bench, Words words, AccuracyMeter errors, CostMeter costs) {
        this(demo, bench, words, errors, costs, new Folds());
    }

    /** Plates of a restarted demo, of which those are open that are open here. */
    DemoPlates of(Demo demo, Workbench other, Words words, AccuracyMeter errors, CostMeter costs) {
        DemoPlates next = new DemoPlates(demo, other, words, errors, costs, folds);
        next.isHidden = isHidden;
        next.haunt();
        return next;
    }

    /**
     * Opens the ghost's plate when the demo begins to want it, and folds it when it no longer does.
     */
    void wantGhost(boolean isWanted) {
        if (isWanted != wasGhostWanted) {
            wasGhostWanted = isWanted;
            if (!isWanted) {
                folds.layTheGhost();
            } else if (!folds.isOneAtATime()) {
                // It would take the place of the controls that asked for it.
                folds.open(Fold.GHOST);
            }
        }
        haunt();
    }

    boolean isGhostOpen() {
        return folds.isOpen(Fold.GHOST);
    }

    void openGhost() {
        folds.open(Fold.GHOST);
    }

    /** Makes a ghost while its plate is open or the demo wants it. */
    private void haunt() {
        bench.haunt(folds.isOpen(Fold.GHOST) || folds.isOneAtATime() && wasGhostWanted);
    }

    void beforeStep() {
        side.beforeStep();
    }

    void afterStep() {
        side.afterStep();
        accuracy.stepped();
    }

    /** A frame was drawn and took this long, ns. */
    void drawn(long nanos) {
        side.drawn(nanos);
        effects.turn();
        accuracy.turn();
    }

    void paced(double share) {
        accuracy.paced(share);
    }

    /**
     * Draws what there is room for. A handheld window, which has no keys, also gets buttons, some
     * of them beside the tabs.
     */
    void draw(
            Canvas canvas,
            boolean isPaused,
            List<HandButtons.Item> items,
            List<HandButtons.Item> more) {
        Layout layout = canvas.layout();
        folds.fit(layout, mostColumns);
        haunt();
        forget();
        if (layout.isInHand()) {
            drawInHand(canvas, isPaused, items, more);
            return;
        }
        inHand = Optional.empty();
        if (isHidden) {
            return;
        }
        switch (folds.columns()) {
            case 0 -> drawOver(canvas, isPaused);
            case 1 -> drawColumn(canvas, isPaused);
            default -> drawColumns(canvas, isPaused);
        }
    }

    /** Forgets all places: plates that are not drawn cannot be pressed. */
    private void forget() {
        tabs.clear();
        buttons.clear();
        sidePlace = Plate.NONE;
        accuracy.hide();
        if (isHidden || !folds.isOpen(Fold.EFFECTS)) {
            effects.hide();
        }
        controls.hide();
    }

    private void drawOver(Canvas canvas, boolean isPaused) {
        double width = Scene.WIDTH - 2 * EDGE;
        double type = canvas.layout().type();
        accuracy.draw(canvas, EDGE, EDGE, width, isPaused);
        double row = EDGE + AccuracyBar.height(canvas.layout(), width) + GAP;
        double sideWidth = SIDE_WIDTH * type;
        double right = Scene.WIDTH - EDGE - sideWidth;
        double controlsWidth = Math.min(WIDEST_CONTROLS, DemoControls.WIDTH * type);
        tabs.draw(canvas, tabs(fold -> !fold.isAtTheSide()), EDGE, row, controlsWidth);
        tabs.draw(canvas, tabs(Fold::isAtTheSide), right, row, sideWidth);
        double below = row + Tabs.HEIGHT + Tabs.GAP;
        if (folds.isOpen(Fold.CONTROLS)) {
            controls.draw(canvas, EDGE, below, controlsWidth);
        }
        if (folds.isOpen(Fold.EFFECTS)) {
            effects.drawAbove(canvas, EDGE, Scene.HEIGHT - EDGE, width);
        }
        drawSide(canvas, right, below, sideWidth);
    }

    private void drawColumn(Canvas canvas, boolean isPaused) {
        Layout layout = canvas.layout();
        double x = layout.leftColumn();
        double width = layout.columnWidth();
        accuracy.draw(canvas, x, EDGE, width, isPaused);
        double row = EDGE + AccuracyBar.height(layout, width) + GAP;
        tabs.draw(canvas, tabs(fold -> !fold.isAtTheSide()), x, row, width);
        row += Tabs.HEIGHT + Tabs.GAP;
        tabs.draw(canvas, tabs(Fold::isAtTheSide), x, row, width);
        double below = row + Tabs.HEIGHT + Tabs.GAP;
        if (folds.isOpen(Fold.CONTROLS)) {
            controls.draw(canvas, x, below, width);
        }
        if (folds.isOpen(Fold.EFFECTS)) {
            effects.draw(canvas, x, below, width);
        }
        drawSide(canvas, x, below, width);
    }

    private void drawColumns(Canvas canvas, boolean isPaused) {
        Layout layout = canvas.layout();
        double width = layout.columnWidth();
        double left = layout.leftColumn();
        accuracy.draw(canvas, left, EDGE, width, isPaused);
        controls.draw(canvas, left, EDGE + AccuracyBar.height(layout, width) + GAP, width);
        double right = layout.rightColumn();
        tabs.draw(canvas, tabs(Fold::isAtTheSide), right, EDGE, width);
        drawSide(canvas, right, EDGE + Tabs.HEIGHT + Tabs.GAP, width);
        effects.draw(canvas, right, sidePlace.bottom() + GAP, width);
    }

    /** Draws buttons and tabs around the scene, and over it the plate that is open. */
    private void drawInHand(
            Canvas canvas,
            boolean isPaused,
            List<HandButtons.Item> items,
            List<HandButtons.Item> more) {
        Enlarged enlarged = new Enlarged(canvas);
        List<Fold> tabbed = tabs(fold -> true);
        HandFrame places =
                HandFrame.of(enlarged.layout(), items.size(), tabbed.size() + more.size());
        inHand = Optional.of(enlarged);
        buttons.draw(enlarged, places.buttons(), items);
        tabs.draw(enlarged, tabbed, places.tabs());
        buttons.draw(enlarged, places.tabs().subList(tabbed.size(), places.tabs().size()), more);
        for (Fold fold : tabbed) {
            if (folds.isOpen(fold)) {
                draw(enlarged, fold, places.room(), isPaused);
            }
        }
    }

    private void draw(Canvas canvas, Fold fold, Plate room, boolean isPaused) {
        switch (fold) {
            case CONTROLS -> controls.drawControls(canvas, room);
            case NUMBERS -> controls.drawNumbers(canvas, room);
            case ACCURACY -> accuracy.draw(canvas, room.x(), room.y(), room.width(), isPaused);
            case EFFECTS -> effects.draw(canvas, room);
            case FRAME, ENERGY, GHOST -> drawSide(canvas, room.x(), room.y(), room.width());
        }
    }

    /** Where a point, px, is on the canvas of the plates. */
    private double plateX(double x) {
        return inHand.map(canvas -> canvas.x(x)).orElse(x);
    }

    private double plateY(double y) {
        return inHand.map(canvas -> canvas.y(y)).orElse(y);
    }

    private List<Fold> tabs(Predicate<Fold> wanted) {
        return Arrays.stream(Fold.values()).filter(wanted).filter(folds::hasTab).toList();
    }

    private void drawSide(Canvas canvas, double x, double y, double width) {
        for (Fold fold : tabs(Fold::isAtTheSide)) {
            if (folds.isOpen(fold)) {
                sidePlace = new Plate(x, y, width, SidePlate.height(fold));
                side.draw(canvas, fold, x, y, width);
            }
        }
    }

    /** Tells of all that is drawn and can be used. */
    void describe(Narrator narrator) {
        buttons.describe(narrator);
        Narrator own = inHand.map(canvas -> canvas.telling(narrator)).orElse(narrator);
        accuracy.describe(own);
        tabs.describe(own);
        controls.describe(own);
        effects.describe(own);
    }

    /** Whether a point lies on a plate. */
    boolean contain(double px, double py) {
        double x = plateX(px);
        double y = plateY(py);
        return controls.contains(x, y)
                || accuracy.contains(x, y)
                || effects.contains(x, y)
                || sidePlace.contains(x, y)
                || tabs.at(x, y).isPresent()
                || button(px, py).isPresent();
    }

    /** The button at a point, px, in a handheld window. */
    Optional<HandButtons.Item> button(double px, double py) {
        return buttons.at(px, py);
    }

    /** When a finger at a point, px, presses. */
    Tap tap(double px, double py) {
        double x = plateX(px);
        double y = plateY(py);
        if (controls.contains(x, y)) {
            return controls.tap(x, y);
        }
        return contain(px, py) ? Tap.LIFTED : Tap.AT_ONCE;
    }

    void pointerMoved(double px, double py) {
        double x = plateX(px);
        double y = plateY(py);
        controls.pointerMoved(x, y);
        accuracy.pointerMoved(x, y);
        effects.pointerMoved(x, y);
    }

    /** Handles a press of the left button; returns whether on a plate. */
    boolean pointerPressed(double px, double py) {
        boolean isOnPlate = contain(px, py);
        double x = plateX(px);
        double y = plateY(py);
        tabs.at(x, y).ifPresent(folds::toggle);
        controls.pointerPressed(x, y);
        accuracy.pointerPressed(x, y);
        effects.pointerPressed(x, y);
        return isOnPlate;
    }

    void pointerReleased() {
        controls.pointerReleased();
    }

    /** Handles a key for the plates; returns whether it is one. */
    boolean keyPressed(Key key) {
        if (areControlsShown() && controls.keyPressed(key)) {
            return true;
        }
        switch (key) {
            case DIGIT_1, DIGIT_2, DIGIT_3, DIGIT_4 ->
                    accuracy.choose(Preset.values()[key.ordinal() - Key.DIGIT_1.ordinal()]);
            case T -> isHidden = !isHidden;
            case C -> toggle(Fold.CONTROLS);
            case E -> toggle(Fold.EFFECTS);
            case N -> toggle(Fold.ENERGY);
            case G -> toggle(Fold.GHOST);
            default -> {
                return false;
            }
        }
        return true;
    }

    private boolean areControlsShown() {
        return !isHidden && folds.isOpen(Fold.CONTROLS);
    }

    /** Folds or unfolds a plate that has a tab; all are shown again to show it. */
    private void toggle(Fold fold) {
        if (folds.hasTab(fold)) {
            folds.toggle(fold);
            isHidden = isHidden && !folds.isOpen(fold);
        }
        haunt();
    }
}
