package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Plate;

/**
 * Where the parts of the laboratory are, logical px; in a handheld window, px of a sheet.
 *
 * @param commands the buttons that replace keys in a handheld window
 * @param experiments the buttons of the experiments
 * @param rows number of rows of those buttons
 * @param left the left half
 * @param right the right half
 * @param status the line with the cost of a step and the pace
 * @param drawers the buttons that choose the graph
 * @param graph the graph, or the sliders
 */
record LaboratoryPlaces(
        Plate commands,
        Plate experiments,
        int rows,
        Plate left,
        Plate right,
        Plate status,
        Plate drawers,
        Plate graph) {

    private static final double EDGE = 8;
    private static final double GAP = 6;
    private static final double STATUS = 34;
    private static final double STATUS_IN_HAND = 50;

    /** Least width of what stands beside the halves in a window that lies, px. */
    private static final double BESIDE = 339;

    /** Height that is left for the graph in an upright window, px. */
    private static final double GRAPH = 150;

    /** The places in a desktop window. */
    static final LaboratoryPlaces ON_A_DESK = onADesk();

    static LaboratoryPlaces of(Layout layout) {
        return layout.choose(ON_A_DESK, LaboratoryPlaces::upright, LaboratoryPlaces::lying);
    }

    private static LaboratoryPlaces onADesk() {
        double width = Scene.WIDTH - 2 * EDGE;
        Plate bar = new Plate(EDGE, EDGE, width, ButtonBar.HEIGHT);
        double top = bar.bottom() + GAP;
        Plate left = new Plate(EDGE, top, HalfView.WIDTH, HalfView.HEIGHT);
        Plate right =
                new Plate(Scene.WIDTH - EDGE - HalfView.WIDTH, top, HalfView.WIDTH, left.height());
        Plate status = new Plate(EDGE, left.bottom() + GAP, width, STATUS);
        Plate drawers = status.below(GAP, ButtonBar.HEIGHT);
        double graph = drawers.bottom() + GAP;
        return new LaboratoryPlaces(
                Plate.NONE,
                bar,
                1,
                left,
                right,
                status,
                drawers,
                new Plate(EDGE, graph, width, Scene.HEIGHT - EDGE - graph));
    }

    /** Everything in one column; the halves take the remaining room above the graph. */
    private static LaboratoryPlaces upright(Layout sheet) {
        double finger = sheet.clickable(0);
        Plate seen = Plate.seen(sheet, EDGE);
        double x = seen.x();
        double width = seen.width();
        Plate commands = new Plate(x, seen.y(), width, finger);
        Plate experiments = commands.below(GAP, finger);
        double top = experiments.bottom() + GAP;
        double foot = seen.bottom();
        double rest = foot - top - 3 * GAP - STATUS_IN_HAND - finger - GRAPH;
        double half = (width - GAP) / 2;
        double height = Math.min(rest, HalfView.height(sheet, half));
        Plate left = new Plate(x, top, half, height);
        Plate status = new Plate(x, left.bottom() + GAP, width, STATUS_IN_HAND);
        Plate drawers = status.below(GAP, finger);
        double graph = drawers.bottom() + GAP;
        return new LaboratoryPlaces(
                commands,
                experiments,
                1,
                left,
                new Plate(x + width - half, top, half, height),
                status,
                drawers,
                new Plate(x, graph, width, foot - graph));
    }

    /** The halves with their status line, and beside them buttons and graph. */
    private static LaboratoryPlaces lying(Layout sheet) {
        double finger = sheet.clickable(0);
        Plate seen = Plate.seen(sheet, EDGE);
        double x = seen.x();
        double top = seen.y();
        double height = seen.height() - GAP - STATUS_IN_HAND;
        double most = (seen.width() - EDGE - BESIDE - GAP) / 2;
        double half = Math.min(most, HalfView.width(sheet, height));
        Plate left = new Plate(x, top, half, height);
        Plate right = new Plate(left.right() + GAP, top, half, height);
        double beside = right.right() + EDGE;
        Plate commands = new Plate(beside, top, seen.right() - beside, finger);
        Plate experiments = commands.below(GAP, 2 * finger);
        Plate drawers = experiments.below(GAP, finger);
        double graph = drawers.bottom() + GAP;
        return new LaboratoryPlaces(
                commands,
                experiments,
                2,
                left,
                right,
                new Plate(x, left.bottom() + GAP, right.right() - x, STATUS_IN_HAND),
                drawers,
                new Plate(beside, graph, commands.width(), seen.bottom() - graph));
    }
}
