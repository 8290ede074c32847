package rigibo.frontend.editor;

import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Where things are in a handheld window, px of a sheet: buttons above and below the draft, or
 * beside it.
 *
 * @param commands the commands that are always there
 * @param tabs the tabs that open the drawer
 * @param status the line that tells what was done last, or what can be done
 * @param zoom the two buttons for zooming
 * @param draft the room for the draft
 * @param drawer the open and full drawer, which lies over a part of the draft
 */
record EditorPlaces(
        List<Area> commands,
        List<Area> tabs,
        Area status,
        List<Area> zoom,
        Area draft,
        Area drawer) {

    static final int COMMANDS = 4;
    static final int TABS = 5;

    private static final double GAP = 6;

    /** Lines that the status has room for. */
    private static final int LINES = 3;

    /** Width of buttons and status beside the draft, px. */
    private static final double STRIP = 206;

    /** Width of the drawer beside the draft: least, most, and as a share of what there is, px. */
    private static final double NARROWEST = 340;

    private static final double WIDEST = 400;
    private static final double SHARE = 0.5;

    /** Rows of the height of a finger that the drawer has at least. */
    private static final double ROWS = 6.6;

    static EditorPlaces of(Layout sheet) {
        return sheet.isUpright() ? upright(sheet) : lying(sheet);
    }

    private static EditorPlaces upright(Layout sheet) {
        double finger = sheet.clickable(0);
        double left = sheet.seenLeft() + GAP;
        double width = sheet.seenRight() - GAP - left;
        Plate first = new Plate(left, sheet.seenTop() + GAP, width, finger);
        Plate last = new Plate(left, sheet.seenBottom() - GAP - finger, width, finger);
        double lines = LINES * Pane.LINE;
        double status = last.y() - GAP - lines;
        double zoomed = 2 * finger + GAP;
        double button = status + (lines - finger) / 2;
        Plate zoom = new Plate(left + width - zoomed, button, zoomed, finger);
        double top = first.bottom() + GAP;
        double room = status - GAP - top;
        double drawer = Math.max(ROWS * finger, SHARE * room);
        return new EditorPlaces(
                places(Grid.of(first, COMMANDS, GAP), 0, COMMANDS),
                places(Grid.of(last, TABS, GAP), 0, TABS),
                new Area(left, status, width - zoomed - GAP, lines),
                places(Grid.of(zoom, 2, GAP), 0, 2),
                new Area(left, top, width, room),
                new Area(left, status - GAP - drawer, width, drawer));
    }

    private static EditorPlaces lying(Layout sheet) {
        double finger = sheet.clickable(0);
        double left = sheet.seenLeft() + GAP;
        double top = sheet.seenTop() + GAP;
        double bottom = sheet.seenBottom() - GAP;
        double strip = STRIP - GAP;
        Grid buttons = Grid.of(new Plate(left, top, strip, finger), 2, GAP);
        double status = buttons.place(COMMANDS + TABS).bottom() + GAP;
        double draft = left + STRIP;
        Plate zoom = new Plate(draft, top, 2 * finger + GAP, finger);
        double room = sheet.seenRight() - GAP - draft;
        double drawer = Math.max(NARROWEST, Math.min(WIDEST, SHARE * room));
        return new EditorPlaces(
                places(buttons, 0, COMMANDS),
                places(buttons, COMMANDS, COMMANDS + TABS),
                new Area(left, status, strip, bottom - status),
                places(Grid.of(zoom, 2, GAP), 0, 2),
                new Area(draft, top, room, bottom - top),
                new Area(draft + room - drawer, top, drawer, bottom - top));
    }

    private static List<Area> places(Grid grid, int from, int to) {
        return IntStream.range(from, to).mapToObj(grid::place).map(Area::of).toList();
    }

    /** The places around the draft, up to the edges of a window. */
    List<Area> frame(Layout sheet) {
        double width = sheet.width();
        double height = sheet.height();
        double below = status.y() - GAP / 2;
        return sheet.isUpright()
                ? List.of(
                        new Area(0, 0, width, draft.y() - GAP / 2),
                        new Area(0, below, width, height - below))
                : List.of(new Area(0, 0, draft.x() - GAP / 2, height));
    }

    /** The drawer, no higher than its content, px: at the foot of the draft, or beside it. */
    Area drawer(double height) {
        double spare = Math.max(0, drawer.height() - height);
        return isBelow() ? drawer.raised(-spare) : drawer.shortened(spare);
    }

    private boolean isBelow() {
        return drawer.width() == draft.width();
    }

    /** The room that an open drawer leaves for the draft. */
    Area beside(Area open) {
        return isBelow()
                ? new Area(draft.x(), draft.y(), draft.width(), open.y() - GAP - draft.y())
                : new Area(draft.x(), draft.y(), open.x() - GAP - draft.x(), draft.height());
    }
}
