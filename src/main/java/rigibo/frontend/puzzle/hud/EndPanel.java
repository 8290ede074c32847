package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.rules.Loss;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Sign;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The panel at the end of a try: the outcome, the prizes, and the next commands. */
final class EndPanel {

    /** Position over the play, px. */
    private static final Plate OVER = new Plate((Scene.WIDTH - 620) / 2.0, 0, 620, 0);

    /** Distance from the upper edge of the window to the plate beside the play, px. */
    private static final double EDGE = 8;

    private static final double PADDING = 20;

    private static final double HEADLINE = 42;
    private static final double HEADLINE_SIZE = 34;

    /** Distance from the upper edge to the middle of the first prize, px. */
    private static final double PRIZES = 104;

    /** Distance from the upper edge to the middle of the reason's first line, px. */
    private static final double REASON = 84;

    private static final double REASON_SIZE = 20;
    private static final double REASON_LINE = 26;

    /** Size of the small text below and distance of its lines, px. */
    private static final double TOLD_SIZE = 17;

    private static final double TOLD_LINE = 22;

    /** Distance from the lower edge of the part above to the middle of the first line, px. */
    private static final double TO_TOLD = 18;

    /** Distance from the part above to the buttons, px. */
    private static final double TO_BUTTONS = 10;

    /** Distance from the left edge of the plate beside the play to the middle of a prize, px. */
    private static final double INDENT = 56;

    private final PuzzleGame game;
    private final List<Command> ways;
    private final Optional<MedalStamps> stamps;
    private final Optional<StarStamp> star;

    /** Heights of the play, and of the balls and the platform in it. */
    private Span play = new Span(0, 0);

    private List<Span> kept = List.of();

    /** Position in the last drawing. */
    private Plate plate = Plate.NONE;

    private Grid grid = Grid.of(Plate.NONE, 1, 0);
    private ButtonRow buttons;

    /**
     * The panel at the end of a game.
     *
     * @param next the way on, if there is one
     * @param exit the way out of the level
     * @param star the level's star, if it has one; shown only if the level is solved
     */
    EndPanel(PuzzleGame game, Optional<Command> next, Command exit, Optional<StarStamp> star) {
        this.game = game;
        this.star = star.filter(one -> game.isSolved());
        int par = game.level().limits().par();
        stamps =
                game.isSolved()
                        ? Optional.of(new MedalStamps(Medal.of(game.clicks(), par), par))
                        : Optional.empty();
        ways = ways(next, exit);
        buttons = new ButtonRow(grid, ways);
    }

    /** Whether the time between clicks may have lost the game; a pause would give it back. */
    private boolean isTimed() {
        return game.loss().isPresent() && game.level().limits().par() > 1;
    }

    /**
     * Sets the heights available to the panel in a window without room beside the play.
     *
     * @param between heights from the top of the play to the top of the keys
     * @param visible heights that should stay uncovered if there is room
     */
    void place(Span between, List<Span> visible) {
        play = between;
        kept = visible;
    }

    /**
     * Places the panel where there is room; its buttons begin {@code toButtons} px below its upper
     * edge.
     */
    private void layOut(Layout layout, double toButtons) {
        Plate width = width(layout);
        double each = layout.clickable(ButtonRow.HEIGHT);
        int columns = isBeside(layout) ? 1 : layout.isInHand() ? 2 : ways.size();
        Plate row = new Plate(width.x() + PADDING, 0, width.width() - 2 * PADDING, each);
        double rows = Grid.of(row, columns, ButtonRow.GAP).height(ways.size());
        double height = toButtons + rows + PADDING;
        plate = new Plate(width.x(), top(layout, height), width.width(), height);
        Plate first = new Plate(row.x(), plate.y() + toButtons, row.width(), each);
        Grid fitting = Grid.of(first, columns, ButtonRow.GAP);
        if (!fitting.equals(grid)) {
            grid = fitting;
            buttons = buttons.at(grid);
        }
    }

    private double top(Layout layout, double height) {
        return isBeside(layout) ? EDGE : play.clearTop(height, kept);
    }

    /** Whether the window has room for it in the left column; drawers open in the other one. */
    private static boolean isBeside(Layout layout) {
        return layout.columns() == 2 && !layout.isInHand();
    }

    private static Plate width(Layout layout) {
        return isBeside(layout) ? new Plate(layout.leftColumn(), 0, layout.columnWidth(), 0) : OVER;
    }

    boolean isOf(PuzzleGame other) {
        return game == other;
    }

    private List<Command> ways(Optional<Command> next, Command exit) {
        List<Command> ways = new ArrayList<>();
        if (game.isSolved()) {
            next.ifPresent(ways::add);
        }
        ways.add(Command.RESTART);
        if (game.isSolved()) {
            ways.add(Command.REPLAY);
        } else {
            ways.add(Command.UNDO);
        }
        ways.add(exit);
        return ways;
    }

    ButtonRow buttons() {
        return buttons;
    }

    /** Whether a point lies on the panel as drawn last. */
    boolean contains(double x, double y) {
        return plate.contains(x, y);
    }

    /** Called after each frame. */
    void turn() {
        stamps.ifPresent(MedalStamps::turn);
        star.ifPresent(StarStamp::turn);
    }

    void draw(Canvas canvas, Words words, Motion motion) {
        Layout layout = canvas.layout();
        double room = width(layout).width() - 2 * PADDING;
        Paragraph reason = Paragraph.of(canvas, reasons(words), REASON_SIZE, REASON_LINE, room);
        Paragraph told = told(canvas, told(words, layout), room);
        double end = stamps.isPresent() ? prizes(layout, 0).bottom(count()) : reason.bottom(REASON);
        double first = end + layout.lettered(TO_TOLD);
        double later = told(canvas, toldLater(words), room).bottom(first);
        double bottom = Math.max(end, Math.max(told.bottom(first), later));
        layOut(layout, bottom + layout.lettered(TO_BUTTONS));
        drawPlate(canvas, words);
        PrizePlaces prizes = prizes(layout, plate.y());
        stamps.ifPresent(medals -> medals.draw(canvas, words, prizes, motion));
        star.ifPresent(one -> one.draw(canvas, words, prizes, motion));
        reason.draw(canvas, middle(), plate.y() + REASON, Color.TEXT);
        told.draw(canvas, middle(), plate.y() + first, Color.BRASS);
        buttons.draw(canvas, words);
    }

    private static Paragraph told(Canvas canvas, String words, double room) {
        return Paragraph.of(canvas, words, TOLD_SIZE, TOLD_LINE, room);
    }

    /** The text that appears with the star; room for it is kept from the start. */
    private String toldLater(Words words) {
        return star.map(one -> one.told(words)).orElse("");
    }

    /** The reason for the end, if no prize was earned. */
    private String reasons(Words words) {
        return stamps.isPresent() ? "" : words.of(reason());
    }

    /** The small text: the star's condition, or a way to gain time. */
    private String told(Words words, Layout layout) {
        if (isTimed()) {
            return words.of(layout.isInHand() ? "puzzle.short.pause" : "puzzle.loss.pause");
        }
        return star.map(one -> one.statement(words)).orElse("");
    }

    private int count() {
        return Medal.values().length + (star.isPresent() ? 1 : 0);
    }

    /** Places of the medals and, after them, of the star, below an upper edge, px. */
    private PrizePlaces prizes(Layout layout, double top) {
        return isBeside(layout)
                ? new PrizePlaces(plate.x() + INDENT, top + PRIZES, false)
                : PrizePlaces.across(middle(), top + PRIZES, count());
    }

    private double middle() {
        return plate.x() + plate.width() / 2;
    }

    private void drawPlate(Canvas canvas, Words words) {
        boolean isWon = game.outcome() == Outcome.WON;
        Color edge = game.isSolved() ? Color.GOOD : isWon ? Color.BRASS : Color.BAD;
        canvas.panel(plate.x(), plate.y(), plate.width(), plate.height(), 18, Color.PANEL);
        canvas.frame(plate.x(), plate.y(), plate.width(), plate.height(), 18, edge);
        drawHeadline(canvas, headline(words), edge, isWon);
    }

    private String headline(Words words) {
        return words.of(game.outcome() == Outcome.WON ? "puzzle.won" : "puzzle.lost");
    }

    /** Describes the outcome, the prizes and the next commands to a screen reader. */
    void describe(Narrator narrator, Words words) {
        narrator.says(headline(words));
        narrator.says(stamps.map(it -> it.told(words)).orElseGet(() -> words.of(reason())));
        star.ifPresent(it -> narrator.says(it.told(words)));
        if (isTimed()) {
            narrator.says(words.of("puzzle.short.pause"));
        }
        buttons.describe(narrator, words);
    }

    /** The reason for a loss, or for a win that does not count. */
    private String reason() {
        return game.loss().map(EndPanel::key).orElse("puzzle.experiment.end");
    }

    private static String key(Loss loss) {
        return "puzzle.loss." + Command.key(loss);
    }

    private void drawHeadline(Canvas canvas, String headline, Color color, boolean isWon) {
        double y = plate.y() + HEADLINE;
        double half = canvas.textWidth(headline, HEADLINE_SIZE, Canvas.Font.WORDS) / 2;
        Print.centred(canvas, headline, middle(), y, HEADLINE_SIZE, Color.TEXT);
        double x = middle() - half - 34;
        canvas.ring(x, y, 15, 4, 1, color);
        if (isWon) {
            Sign.tick(canvas, x, y, 7, 3, color);
        } else {
            Sign.cross(canvas, x, y, 6, 3, color);
        }
    }
}
