package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Where buttons and plates are around a scene in a handheld window, px of a sheet: above and below
 * the scene, or beside it.
 *
 * @param buttons the first ones
 * @param tabs those that follow, if there are any
 * @param free the room left beside the scene, or above it
 * @param room for a plate that is open, over the scene
 */
public record HandFrame(List<Plate> buttons, List<Plate> tabs, Plate free, Plate room) {

    private static final double GAP = 6;

    /** Most tabs side by side in an upright window. */
    private static final int TABS_UPRIGHT = 4;

    /** Buttons and tabs side by side in a window that lies. */
    private static final int LYING = 2;

    /** Most of the width of an open plate, px. */
    private static final double WIDEST = 480;

    /** A frame for a number of buttons and tabs. */
    public static HandFrame of(Layout sheet, int buttons, int tabs) {
        return sheet.isUpright() ? upright(sheet, buttons, tabs) : lying(sheet, buttons, tabs);
    }

    private static HandFrame upright(Layout sheet, int buttons, int tabs) {
        double finger = sheet.clickable(0);
        Plate seen = Plate.seen(sheet, GAP);
        double left = seen.x();
        double width = seen.width();
        Plate first = new Plate(left, seen.y(), width, finger);
        int columns = Math.max(1, Math.min(TABS_UPRIGHT, tabs));
        double height = Grid.of(first, columns, GAP).height(tabs);
        double row = seen.bottom() - height;
        double top = first.bottom() + GAP;
        double scene = (sheet.height() - sheet.width() * Scene.HEIGHT / Scene.WIDTH) / 2;
        return new HandFrame(
                places(Grid.of(first, buttons, GAP), 0, buttons),
                places(Grid.of(new Plate(left, row, width, finger), columns, GAP), 0, tabs),
                new Plate(left, top, width, Math.max(0, scene - top)),
                new Plate(left, top, Math.min(WIDEST, width), row - GAP - top));
    }

    private static HandFrame lying(Layout sheet, int buttons, int tabs) {
        Plate seen = Plate.seen(sheet, GAP);
        double scene = sheet.height() * Scene.WIDTH / Scene.HEIGHT;
        double beside = (sheet.width() - scene) / 2;
        double end = beside - GAP;
        Plate row = new Plate(seen.x(), seen.y(), end - seen.x(), sheet.clickable(0));
        Grid all = Grid.of(row, LYING, GAP);
        double width = Math.min(WIDEST, seen.right() - end - GAP);
        double free = beside + scene + GAP;
        return new HandFrame(
                places(all, 0, buttons),
                places(all, buttons, buttons + tabs),
                new Plate(free, seen.y(), seen.right() - free, seen.height()),
                new Plate(seen.right() - width, seen.y(), width, seen.height()));
    }

    private static List<Plate> places(Grid grid, int from, int to) {
        return IntStream.range(from, to).mapToObj(grid::place).toList();
    }
}
