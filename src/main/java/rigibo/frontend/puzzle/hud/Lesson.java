package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.level.Clickable;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings.Motion;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The lesson of the first level with a new verb, until it was solved: a hand shows the first click,
 * beside known verbs or not. The game's first level also explains the cooldown, the counted clicks
 * and the hold when they first occur.
 */
public final class Lesson {

    /** A cycle of the hand: it comes to its target, presses, stays, and is away for a while. */
    private static final int ROUND = Steps.of(3);

    private static final int COMES = Steps.of(0.6);
    private static final int ARRIVES = Steps.of(1.6);
    private static final int LIFTS = Steps.of(1.8);
    private static final int RIPPLES = Steps.of(2.2);

    /** Starting point of the hand, relative to its target, px. */
    private static final double FROM_X = 90;

    private static final double FROM_Y = 120;

    private final Optional<String> target;
    private final boolean isFirst;
    private int turns;

    private Lesson(Optional<String> target, boolean isFirst) {
        this.target = target;
        this.isFirst = isFirst;
    }

    /** The lesson of one of several levels, which are played in their order. */
    public static Lesson of(List<Level> levels, int number, boolean isSolved) {
        Level level = levels.get(number);
        Optional<String> first =
                level.solutions().stream().findFirst().map(it -> it.clicks().get(0).target());
        Set<Verb> known =
                levels.subList(0, number).stream()
                        .flatMap(it -> verbs(it).stream())
                        .collect(Collectors.toSet());
        Set<Verb> fresh = verbs(level);
        fresh.removeAll(known);
        boolean teaches =
                !isSolved
                        && fresh.size() == 1
                        && first.flatMap(level::verb).filter(fresh::contains).isPresent();
        return new Lesson(first.filter(it -> teaches), !isSolved && number == 0);
    }

    /** A level without a lesson. */
    public static Lesson none() {
        return new Lesson(Optional.empty(), false);
    }

    private static Set<Verb> verbs(Level level) {
        return level.clickables().stream().map(Clickable::verb).collect(Collectors.toSet());
    }

    /** After each frame. */
    public void turn() {
        turns = (turns + 1) % ROUND;
    }

    /** Key of the words for the bar, while there is something to explain. */
    Optional<String> words(PuzzleGame game) {
        if (!isFirst || game.outcome() != Outcome.RUNNING) {
            return Optional.empty();
        }
        if (game.held() > 0) {
            return Optional.of("puzzle.lesson.hold");
        }
        if (game.cooldownLeft() > 0) {
            return Optional.of("puzzle.lesson.cooldown");
        }
        return game.clicks() > 0 ? Optional.of("puzzle.lesson.par") : Optional.empty();
    }

    /** Draws the hand until the first click. */
    public void draw(Canvas canvas, Session session, Camera camera, Motion motion) {
        PuzzleGame game = session.game();
        boolean isAsked =
                !session.isShowing()
                        && !session.isPaused()
                        && game.clicks() == 0
                        && game.outcome() == Outcome.RUNNING;
        if (isAsked) {
            target.flatMap(game::target)
                    .filter(Target::isClickable)
                    .ifPresent(at -> draw(canvas, camera, at, motion));
        }
    }

    private void draw(Canvas canvas, Camera camera, Target at, Motion motion) {
        double x = camera.screenX(at.x());
        double y = camera.screenY(at.y());
        int turn = motion == Motion.FULL ? turns : ARRIVES;
        if (turn < COMES) {
            return;
        }
        double away = away(turn);
        // Without room below, the hand comes from above.
        double fromY = y + FROM_Y > View.KEYS_TOP ? -FROM_Y : FROM_Y;
        double fromX = x + FROM_X > Scene.WIDTH ? -FROM_X : FROM_X;
        if (turn >= ARRIVES && turn < RIPPLES) {
            double share = (turn - ARRIVES) / (double) (RIPPLES - ARRIVES);
            canvas.ring(x, y, 10 + 18 * share, 3, 1, Color.BRASS.alpha(1 - share));
        }
        boolean isPressing = turn >= ARRIVES && turn < LIFTS;
        drawHand(canvas, x + away * fromX, y + away * fromY, isPressing ? 0.9 : 1);
    }

    /** Distance of the hand from its target, from 1 to 0; it slows down as it arrives. */
    private static double away(int turn) {
        double left = Math.max(0, (ARRIVES - turn) / (double) (ARRIVES - COMES));
        return left * left;
    }

    /** Draws a white hand with a dark edge, the tip of its finger at a point, px. */
    private static void drawHand(Canvas canvas, double x, double y, double scale) {
        drawHand(canvas, x, y, scale, 5, Color.NIGHT);
        drawHand(canvas, x, y, scale, 0, Color.TEXT);
    }

    private static void drawHand(
            Canvas canvas, double x, double y, double s, double edge, Color color) {
        finger(canvas, x, y + 4 * s, x + s, y + 26 * s, 8 * s + edge, color);
        for (int i = 1; i <= 3; i++) {
            double left = x + (1 + 7 * i) * s;
            finger(canvas, left, y + (15 + i) * s, left, y + 30 * s, 7.5 * s + edge, color);
        }
        finger(canvas, x - 9 * s, y + 22 * s, x + s, y + 34 * s, 7.5 * s + edge, color);
        canvas.panel(
                x - 3 * s - edge / 2,
                y + 22 * s - edge / 2,
                29 * s + edge,
                22 * s + edge,
                8 * s,
                color);
    }

    /** A line with round ends. */
    private static void finger(
            Canvas canvas, double x, double y, double toX, double toY, double width, Color color) {
        canvas.line(x, y, toX, toY, width, color);
        canvas.disc(x, y, width / 2, color);
        canvas.disc(toX, toY, width / 2, color);
    }
}
