package rigibo.frontend.demo;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Where a demo's parts are in a hand, px of a sheet: buttons and tabs above and below the scene, or
 * beside it.
 *
 * @param buttons in the order of {@link HandButton}
 * @param tabs in the order of {@link Fold}
 * @param room for the plate that is open, over the scene
 */
record DemoPlaces(List<Plate> buttons, List<Plate> tabs, Plate room) {

    private static final double GAP = 6;
    private static final int BUTTONS = HandButton.values().length;
    private static final int TABS = Fold.values().length;

    /** Tabs side by side in an upright window. */
    private static final int TABS_UPRIGHT = 4;

    /** Buttons and tabs side by side in a window that lies. */
    private static final int LYING = 2;

    /** Most of the width of an open plate, px. */
    private static final double WIDEST = 480;

    static DemoPlaces of(Layout sheet) {
        return sheet.isUpright() ? upright(sheet) : lying(sheet);
    }

    private static DemoPlaces upright(Layout sheet) {
        double finger = sheet.clickable(0);
        double left = sheet.seenLeft() + GAP;
        double width = sheet.seenRight() - GAP - left;
        Plate first = new Plate(left, sheet.seenTop() + GAP, width, finger);
        Grid tabs = Grid.of(new Plate(left, 0, width, finger), TABS_UPRIGHT, GAP);
        double row = sheet.seenBottom() - GAP - tabs.height(TABS);
        double top = first.bottom() + GAP;
        return new DemoPlaces(
                places(Grid.of(first, BUTTONS, GAP), 0, BUTTONS),
                places(Grid.of(new Plate(left, row, width, finger), TABS_UPRIGHT, GAP), 0, TABS),
                new Plate(left, top, Math.min(WIDEST, width), row - GAP - top));
    }

    private static DemoPlaces lying(Layout sheet) {
        double left = sheet.seenLeft() + GAP;
        double top = sheet.seenTop() + GAP;
        double scene = sheet.height() * Scene.WIDTH / Scene.HEIGHT;
        double end = (sheet.width() - scene) / 2 - GAP;
        Plate row = new Plate(left, top, end - left, sheet.clickable(0));
        Grid all = Grid.of(row, LYING, GAP);
        double right = sheet.seenRight() - GAP;
        double width = Math.min(WIDEST, right - end - GAP);
        return new DemoPlaces(
                places(all, 0, BUTTONS),
                places(all, BUTTONS, BUTTONS + TABS),
                new Plate(right - width, top, width, sheet.seenBottom() - GAP - top));
    }

    private static List<Plate> places(Grid grid, int from, int to) {
        return IntStream.range(from, to).mapToObj(grid::place).toList();
    }
}
