package rigibo.frontend.editor;

import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.editor.pane.Bar;
import rigibo.frontend.editor.pane.EffectPane;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.editor.pane.ToolPane;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;

import java.util.List;

/**
 * Where things are in a desktop window, logical px: around the draft on a sheet as large as a
 * scene, or in two columns beside it, where that shows the draft larger.
 *
 * @param plates those of commands, effects and status
 * @param commands the buttons at the top
 * @param tools a plate
 * @param fields a plate
 * @param effects the chips of effects
 * @param problems a plate
 * @param status what was done last, and what the pointer is on
 * @param draft the room for the draft
 * @param isBeside whether everything stands in columns
 */
record DeskPlaces(
        List<Area> plates,
        Area commands,
        Area tools,
        Area fields,
        Area effects,
        Area problems,
        Area status,
        Area draft,
        boolean isBeside) {

    /** Places on the sheet, px. */
    static final Area TOOLS = new Area(4, 54, 96, 602);

    static final Area PROBLEMS = new Area(486, 518, 230, 138);
    static final Area FOOT = new Area(4, 662, 712, 134);

    /** The part of the sheet that is left to the draft. */
    static final Area DRAFT = new Area(104, 54, 378, 602);

    private static final Area TOP = new Area(4, 4, 712, 44);
    private static final Area FIELDS = new Area(486, 54, 230, 458);

    private static final double MARGIN = 7;

    /** Between the window's edge, plates and the draft, px. */
    private static final double EDGE = 4;

    static final double GAP = 6;

    /** Between the chips of the effects and the lines below them on the sheet, px. */
    private static final double CHIPS_GAP = 3;

    /** Lines below the chips on the sheet, and their height with all margins, px. */
    private static final int LINES = 3;

    private static final double LINES_HEIGHT = 79;

    /** Height of a row of commands, px. */
    private static final double ROW = 30;

    /** Width of a column: least with text of its usual size, and most, px. */
    private static final double NARROWEST = 230;

    private static final double WIDEST = 330;

    /** Height of the status in a column where problems have room enough, px. */
    private static final double STATUS = 212;

    /** Widest list over the draft, and its least distance from the draft's edges, px. */
    private static final double WIDEST_LIST = 460;

    private static final double LIST_MARGIN = 20;

    static DeskPlaces of(Pane pane, List<Bar.Button> buttons) {
        Layout layout = pane.canvas().layout();
        double width = column(layout);
        Area left = new Area(layout.left() + EDGE, layout.top() + EDGE, width, ROW);
        double draft = left.right() + GAP;
        double right = layout.right() - EDGE - width;
        Area between = new Area(draft, layout.top(), right - GAP - draft, layout.height());
        return between.width() > DRAFT.width() ? beside(pane, buttons, left, between) : sheet(pane);
    }

    /** Width of one of two columns, which leave a scene its whole height where there is room. */
    private static double column(Layout layout) {
        double others = Scene.WIDTH + 2 * (View.MARGIN + GAP + EDGE);
        double least = NARROWEST * layout.type();
        return Math.max(least, Math.min(WIDEST, (layout.width() - others) / 2));
    }

    private static DeskPlaces sheet(Pane pane) {
        Area usual = FOOT.inset(MARGIN);
        double chips = EffectPane.height(pane, usual);
        double risen = chips + LINES_HEIGHT - FOOT.height();
        Area foot = FOOT.raised(risen);
        Area effects = foot.inset(MARGIN);
        double lines = effects.y() + chips + CHIPS_GAP;
        return new DeskPlaces(
                List.of(TOP, foot),
                TOP.inset(MARGIN),
                TOOLS.shortened(risen),
                FIELDS,
                effects,
                PROBLEMS.shortened(risen),
                new Area(effects.x(), lines, effects.width(), LINES * Pane.LINE),
                DRAFT,
                false);
    }

    private static DeskPlaces beside(Pane pane, List<Bar.Button> buttons, Area left, Area draft) {
        double inner = left.width() - 2 * MARGIN;
        double rows = Bar.height(pane, new Area(0, 0, inner, ROW), buttons);
        Area commands = left.resized(rows + Pane.LINE + 2 * MARGIN);
        Area tools = commands.below(GAP, ToolPane.heightInRows(pane, inner) + 2 * MARGIN);
        double bottom = draft.bottom() - EDGE;
        double rest = bottom - tools.bottom() - 2 * GAP;
        Area problems = tools.below(GAP, Math.max(PROBLEMS.height(), rest - STATUS));
        Area status = problems.below(GAP, bottom - problems.bottom() - GAP);
        Area right = new Area(draft.right() + GAP, left.y(), left.width(), bottom - left.y());
        double chips = EffectPane.height(pane, right.inset(MARGIN)) + 2 * MARGIN;
        Area fields = right.shortened(chips + GAP);
        Area effects = fields.below(GAP, chips);
        return new DeskPlaces(
                List.of(commands, tools, effects, status),
                commands.inset(MARGIN).resized(ROW),
                tools.inset(MARGIN),
                fields,
                effects.inset(MARGIN),
                problems,
                status.inset(MARGIN),
                draft,
                true);
    }

    /** A list to choose from, which lies over the draft. */
    Area list() {
        double width = Math.min(WIDEST_LIST, draft.width() - 2 * LIST_MARGIN);
        Area inner = draft.inset(LIST_MARGIN);
        return new Area(draft.middleX() - width / 2, inner.y(), width, inner.height());
    }
}
