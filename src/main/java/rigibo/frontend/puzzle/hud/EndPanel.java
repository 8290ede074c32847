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
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Sign;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The panel at the end of a try: how it ended, what it earned, and what can be done next. */
final class EndPanel {

    private static final double WIDTH = 620;
    private static final double LEFT = (Scene.WIDTH - WIDTH) / 2;
    private static final double PADDING = 20;
    private static final double MIDDLE = Scene.WIDTH / 2.0;

    /** Distance below what is drawn above the play, px. */
    private static final double GAP = 12;

    private static final double HEADLINE = 42;
    private static final double HEADLINE_SIZE = 34;

    /** Distance from the panel's upper edge to the middle between headline and buttons, px. */
    private static final double MEDALS = 104;

    private static final double REASON = 84;

    /** From the line of the reason to that of a tip, px. */
    private static final double TIP = 30;

    /** Height of the line that states a star. */
    private static final double STATEMENT = 34;

    /** Room that two lines of larger text need in a hand, px. */
    private static final double MORE = 70;

    /** Between two lines, px. */
    private static final double LINE = 22;

    private final PuzzleGame game;
    private final List<Command> ways;
    private final Optional<MedalStamps> stamps;
    private final Optional<StarStamp> star;
    private double height;
    private double top;
    private Layout layout = Layout.ALONE;
    private ButtonRow buttons;

    /**
     * The panel at the end of a game.
     *
     * @param exit the way out of the level
     * @param star the level's, where it has one; shown only where the level is solved
     */
    EndPanel(PuzzleGame game, boolean hasNext, Command exit, Optional<StarStamp> star) {
        this.game = game;
        this.star = star.filter(one -> game.isSolved());
        int par = game.level().limits().par();
        stamps =
                game.isSolved()
                        ? Optional.of(new MedalStamps(Medal.of(game.clicks(), par), par))
                        : Optional.empty();
        ways = ways(hasNext, exit);
        place(layout, 0, Scene.HEIGHT, Scene.HEIGHT);
    }

    /** Distance from the panel's upper edge to its buttons, px. */
    private double buttonsBelow() {
        double statement = star.isPresent() ? STATEMENT : 0;
        double tip = isTimed() ? TIP : 0;
        double below = stamps.isPresent() ? MEDALS + 60 + statement : REASON + 24 + tip;
        boolean hasMore = stamps.isPresent() ? star.isPresent() : isTimed();
        return layout.isInHand() && hasMore ? below + MORE : below;
    }

    /** Whether the time between clicks may have lost it, which a pause gives back. */
    private boolean isTimed() {
        return game.loss().isPresent() && game.level().limits().par() > 1;
    }

    /**
     * Places the panel where the play begins, or above the keys if it would cover a ball.
     *
     * @param shown what the window shows
     * @param foot where the play begins, px
     * @param floor where the keys begin, px
     * @param highestBall on the screen, px
     */
    void place(Layout shown, double foot, double floor, double highestBall) {
        layout = shown;
        Grid grid = grid();
        height = buttonsBelow() + grid.height(ways.size()) + PADDING;
        boolean isInTheWay = highestBall < foot + height + 2 * GAP;
        top = isInTheWay ? floor - GAP - height : foot + GAP;
        buttons = new ButtonRow(grid(), ways);
    }

    /** Side by side; in a hand two and two. */
    private Grid grid() {
        double height = layout.clickable(ButtonRow.HEIGHT);
        Plate row = new Plate(LEFT + PADDING, top + buttonsBelow(), WIDTH - 2 * PADDING, height);
        return Grid.of(row, layout.isInHand() ? 2 : ways.size(), ButtonRow.GAP);
    }

    boolean isOf(PuzzleGame other) {
        return game == other;
    }

    private List<Command> ways(boolean hasNext, Command exit) {
        List<Command> ways = new ArrayList<>();
        if (game.isSolved() && hasNext) {
            ways.add(Command.NEXT);
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

    boolean contains(double x, double y) {
        return x >= LEFT && x <= LEFT + WIDTH && y >= top && y <= top + height;
    }

    /** Called after each frame. */
    void turn() {
        stamps.ifPresent(MedalStamps::turn);
        star.ifPresent(StarStamp::turn);
    }

    void draw(Canvas canvas, Words words, Motion motion) {
        boolean isWon = game.outcome() == Outcome.WON;
        Color edge = game.isSolved() ? Color.GOOD : isWon ? Color.BRASS : Color.BAD;
        canvas.panel(LEFT, top, WIDTH, height, 18, Color.PANEL);
        canvas.frame(LEFT, top, WIDTH, height, 18, edge);
        drawHeadline(canvas, headline(words), edge, isWon);
        if (stamps.isPresent()) {
            drawPrizes(canvas, words, stamps.get(), motion);
        } else {
            text(canvas, words.of(reason()), top + REASON, 20, Color.TEXT);
            if (isTimed()) {
                drawTip(canvas, words);
            }
        }
        buttons.draw(canvas, words);
    }

    private String headline(Words words) {
        return words.of(game.outcome() == Outcome.WON ? "puzzle.won" : "puzzle.lost");
    }

    /** Says how it ended and what it earned, and tells of what can be done next. */
    void describe(Narrator narrator, Words words) {
        narrator.says(headline(words));
        narrator.says(stamps.map(it -> it.told(words)).orElseGet(() -> words.of(reason())));
        star.ifPresent(it -> narrator.says(it.told(words)));
        if (isTimed()) {
            narrator.says(words.of("puzzle.short.pause"));
        }
        buttons.describe(narrator, words);
    }

    private void drawTip(Canvas canvas, Words words) {
        if (layout.isInHand()) {
            double y = top + REASON + layout.lettered(TIP);
            lines(canvas, words.of("puzzle.short.pause"), y);
        } else {
            text(canvas, words.of("puzzle.loss.pause"), top + REASON + TIP, 17, Color.BRASS);
        }
    }

    /** Draws the medals, and the star as one more beside them. */
    private void drawPrizes(Canvas canvas, Words words, MedalStamps medals, Motion motion) {
        double aside = star.isPresent() ? MedalStamps.COLUMN / 2 : 0;
        double y = top + MEDALS;
        medals.draw(canvas, words, MIDDLE - aside, y, motion);
        if (star.isPresent()) {
            double x = MIDDLE - aside + 2 * MedalStamps.COLUMN;
            star.get().draw(canvas, words, x, y, motion);
            double line = y + MedalStamps.WORDS_BELOW + STATEMENT - 4;
            if (layout.isInHand()) {
                lines(canvas, star.get().statement(words), line + STATEMENT / 3);
            } else {
                double room = WIDTH - 2 * PADDING;
                text(canvas, star.get().statement(canvas, words, room), line, 17, Color.BRASS);
            }
        }
    }

    /** The reason for a loss, or for a win that does not count. */
    private String reason() {
        return game.loss().map(EndPanel::key).orElse("puzzle.experiment.end");
    }

    private static String key(Loss loss) {
        return "puzzle.loss." + Command.key(loss);
    }

    private void drawHeadline(Canvas canvas, String headline, Color color, boolean isWon) {
        double y = top + HEADLINE;
        double half = canvas.textWidth(headline, HEADLINE_SIZE, Canvas.Font.WORDS) / 2;
        text(canvas, headline, y, HEADLINE_SIZE, Color.TEXT);
        double x = MIDDLE - half - 34;
        canvas.ring(x, y, 15, 4, 1, color);
        if (isWon) {
            Sign.tick(canvas, x, y, 7, 3, color);
        } else {
            Sign.cross(canvas, x, y, 6, 3, color);
        }
    }

    /** Lines of small text below each other, the first of them at a height, px. */
    private static void lines(Canvas canvas, String words, double y) {
        double at = y;
        for (String line : Lines.of(canvas, words, 17, Canvas.Font.WORDS, WIDTH - 2 * PADDING)) {
            text(canvas, line, at, 17, Color.BRASS);
            at += canvas.layout().lettered(LINE);
        }
    }

    private static void text(Canvas canvas, String words, double y, double size, Color color) {
        canvas.text(words, MIDDLE, y, size, Canvas.Font.WORDS, Canvas.Align.CENTRE, color);
    }
}
