package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.level.Clickable;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.session.Pace;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.puzzle.show.CooldownRing;
import rigibo.frontend.puzzle.show.Refusal;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Badge;
import rigibo.frontend.scene.widget.Plate;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** The bar above the play: title, state of the game, counts, and the cooldown's ring. */
final class Hud {

    private static final double EDGE = 8;
    private static final double HEIGHT = View.BAR_FOOT - EDGE;
    private static final double MIDDLE = EDGE + HEIGHT / 2;
    private static final double LEFT = EDGE + 18;
    private static final double TITLE_SIZE = 22;
    private static final double WORDS_SIZE = 17;
    private static final double GAP = 14;

    private static final double RING_X = Scene.WIDTH - 38;
    private static final double COUNTS_RIGHT = Scene.WIDTH - 64;

    /** Left edge of the buttons in the bar, and the width of each, px. */
    private static final double BUTTONS_LEFT = EDGE + 40;

    private static final double BUTTON_WIDTH = 96;

    private final Level level;
    private final Lesson lesson;

    private final Counts counts;
    private final HandBar handBar;

    /** Left edge of the counts as drawn last, px. */
    private double countsLeft = Scene.WIDTH;

    /** Position of the bar in a handheld window. */
    private Plate inHand = Plate.NONE;

    private boolean isAsked;

    /** Share of real time at which the world runs. */
    private double pace = 1;

    Hud(Level level, Lesson lesson) {
        this.level = level;
        this.lesson = lesson;
        counts = new Counts(level.limits());
        handBar = new HandBar(level);
    }

    void paced(double share) {
        pace = share;
    }

    /** Puts buttons into the bar, in place of the title. */
    static ButtonRow buttons(List<Command> commands) {
        double top = MIDDLE - ButtonRow.HEIGHT / 2;
        return new ButtonRow(BUTTONS_LEFT, top, commands.size() * BUTTON_WIDTH, commands);
    }

    /** Draws the bar with the title and the state of the game. */
    void draw(Canvas canvas, Words words, Session session, Refusal refusal, Motion motion) {
        double right = drawRight(canvas, words, session, refusal, motion);
        String title = level.title().in(words.locale());
        text(canvas, title, LEFT, TITLE_SIZE, Color.BRASS);
        double left = LEFT + canvas.textWidth(title, TITLE_SIZE, Canvas.Font.WORDS) + GAP;
        message(words, session, refusal, late(words, session))
                .ifPresent(message -> drawBetween(canvas, message, left, right));
    }

    /** Draws the bar with buttons in place of the title, during a pause. */
    void drawPaused(
            Canvas canvas,
            Words words,
            Session session,
            Refusal refusal,
            ButtonRow buttons,
            Motion motion) {
        drawRight(canvas, words, session, refusal, motion);
        for (int bar = 0; bar < 2; bar++) {
            canvas.panel(LEFT - 6 + 10 * bar, MIDDLE - 9, 6, 18, 2, Color.BRASS);
        }
        buttons.draw(canvas, words);
    }

    /** Draws the bar while something is shown. */
    void drawShow(Canvas canvas, Words words, Session session, ButtonRow buttons, Motion motion) {
        double right = drawRight(canvas, words, session, new Refusal(), motion);
        canvas.line(LEFT - 6, MIDDLE - 9, LEFT + 8, MIDDLE, 3, Color.BRASS);
        canvas.line(LEFT - 6, MIDDLE + 9, LEFT + 8, MIDDLE, 3, Color.BRASS);
        canvas.line(LEFT - 6, MIDDLE - 9, LEFT - 6, MIDDLE + 9, 3, Color.BRASS);
        buttons.draw(canvas, words);
        String what = shown(words, session);
        drawBetween(canvas, what, BUTTONS_LEFT + BUTTON_WIDTH + GAP, right);
    }

    /** Draws the bar of a handheld window, in any state. */
    void drawInHand(
            Canvas canvas,
            Plate bar,
            Words words,
            Session session,
            Refusal refusal,
            Motion motion) {
        inHand = bar;
        Optional<String> said = message(words, session, refusal, late(words, session));
        handBar.draw(canvas, bar, words, session.game(), said, refusal, motion);
    }

    /** Draws words between two positions of the bar, if they fit. */
    private static void drawBetween(Canvas canvas, String state, double left, double right) {
        double width = canvas.textWidth(state, WORDS_SIZE, Canvas.Font.WORDS);
        if (left + width + GAP <= right) {
            text(canvas, state, left, WORDS_SIZE, Color.TEXT);
        }
    }

    /** Draws the plate, with the counts and the ring on its right; returns their left edge, px. */
    private double drawRight(
            Canvas canvas, Words words, Session session, Refusal refusal, Motion motion) {
        PuzzleGame game = session.game();
        canvas.panel(EDGE, EDGE, Scene.WIDTH - 2 * EDGE, HEIGHT, 14, Color.PANEL);
        boolean isSpent = refusal.is(Refusal.Reason.NO_CLICKS_LEFT);
        double aside = refusal.shake(motion);
        double left =
                counts.draw(
                        canvas,
                        words,
                        game,
                        COUNTS_RIGHT + (isSpent ? aside : 0),
                        MIDDLE,
                        isSpent ? Color.BAD : Color.TEXT);
        CooldownRing.drawInBar(canvas, RING_X, MIDDLE, game, refusal, motion);
        countsLeft = left;
        return left;
    }

    /**
     * Draws the explanation of counts and ring over everything below, while the pointer is on them.
     */
    void drawHelp(Canvas canvas, Words words) {
        if (isAsked) {
            counts.drawHelp(canvas, words);
        }
    }

    void pointerMoved(double x, double y) {
        boolean isOnCounts =
                x >= countsLeft && x <= Scene.WIDTH - EDGE && y >= EDGE && y <= View.BAR_FOOT;
        isAsked = inHand == Plate.NONE ? isOnCounts : inHand.contains(x, y);
    }

    /** Whether a point lies on the bar of a handheld window. */
    boolean contains(double x, double y) {
        return inHand.contains(x, y);
    }

    /**
     * The state of the game, or the show; of several messages the most urgent one. A lesson and the
     * task of a level go before the machine's lateness, for slow machines are late all the time.
     */
    private Optional<String> message(
            Words words, Session session, Refusal refusal, Optional<String> late) {
        if (session.isShowing()) {
            return Optional.of(shown(words, session));
        }
        return refusal.reason()
                .map(why -> "puzzle.refused." + key(why))
                .or(() -> lesson.words(session.game()))
                .map(words::of)
                .or(() -> late)
                .or(() -> keyOfState(session).map(words::of));
    }

    private static String shown(Words words, Session session) {
        return words.of("puzzle.show." + key(session.hand()));
    }

    /**
     * Describes the state of the game, or the show, to a screen reader. Delays of the machine
     * change too often.
     */
    void describe(Narrator narrator, Words words, Session session, Refusal refusal) {
        message(words, session, refusal, Optional.empty()).ifPresent(narrator::says);
    }

    private Optional<String> late(Words words, Session session) {
        boolean isSaid = Badge.isLate(pace) && !isUntouched(session);
        return isSaid ? Optional.of(new Badge(words).pace(pace)) : Optional.empty();
    }

    private static Optional<String> keyOfState(Session session) {
        if (session.pace() != Pace.FULL) {
            return Optional.of("puzzle.pace." + key(session.pace()));
        }
        if (session.game().isExperiment()) {
            return Optional.of("puzzle.experiment");
        }
        return isUntouched(session)
                ? Optional.of("puzzle.task." + task(session.game().level()))
                : Optional.empty();
    }

    private static boolean isUntouched(Session session) {
        return session.game().clicks() == 0 && session.game().outcome() == Outcome.RUNNING;
    }

    /** The level's verb, if it has a single one. */
    private static String task(Level level) {
        Set<Verb> verbs =
                level.clickables().stream().map(Clickable::verb).collect(Collectors.toSet());
        return verbs.size() == 1 ? verbs.iterator().next().title() : "many";
    }

    private static String key(Enum<?> constant) {
        return Command.key(constant);
    }

    private static void text(Canvas canvas, String words, double x, double size, Color color) {
        canvas.text(words, x, MIDDLE, size, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
    }
}
