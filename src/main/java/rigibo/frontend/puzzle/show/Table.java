package rigibo.frontend.puzzle.show;

import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.puzzle.rules.Link;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Sounds;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiPredicate;

/** The play area: the bodies, the rings, the particles, and the pointer over them. */
public final class Table {

    /** Distance between the ball and its ring, px. */
    private static final double RING_GAP = 8;

    /** Half the size of a target in the description for screen readers, px. */
    private static final double REACH = 22;

    private static final OptionalDouble NOWHERE = OptionalDouble.empty();

    private final Session session;
    private final Camera camera;
    private final Noises noises;
    private final Stage stage;
    private final Cursor cursor;
    private final HoldRing ring;
    private final Refusal refusal = new Refusal();
    private final Spectacle spectacle;
    private final Lens lens;
    private ShownPointer shownPointer;

    /** Whether a finger is choosing. */
    private boolean isChoosing;

    /** The game on the screen in the last frame. */
    private PuzzleGame seen;

    /** The play area of a session, seen by a camera and heard. */
    public Table(Session session, Camera camera, Sounds sounds) {
        this.session = session;
        this.camera = camera;
        seen = session.game();
        noises = new Noises(sounds, seen);
        stage = new Stage(session, camera);
        spectacle = new Spectacle(session);
        cursor = new Cursor(camera);
        lens = new Lens(session, camera);
        ring = new HoldRing(seen.level().limits().hold());
        shownPointer = new ShownPointer(camera);
    }

    /** One frame of 1/60 s. */
    public void frame() {
        ring.turn();
        int clicks = session.game().clicks();
        boolean isStep = session.frame();
        if (isStep) {
            noises.stepped(session.game());
        }
        if (session.game() != seen) {
            begin();
        } else if (isStep) {
            ring.observe(seen);
            showClicks(clicks);
        }
        refusal.turn();
        spectacle.frame();
        shownPointer.turn();
    }

    /** Called when another game is on the screen. */
    private void begin() {
        seen = session.game();
        ring.reset(seen);
        refusal.forget();
        cursor.letGo();
        shownPointer = new ShownPointer(camera);
    }

    /** Handles the clicks of a show in the last step. */
    private void showClicks(int clicksBefore) {
        List<Act> acts = seen.acts();
        for (Act act : acts.subList(clicksBefore, acts.size())) {
            Target target = seen.target(act.target()).orElseThrow();
            noises.did(target);
            if (target instanceof Piece piece && !piece.isAlive()) {
                Pose pose = session.lastPose(piece.body());
                shownPointer.clicked(pose.x(), pose.y());
            } else {
                shownPointer.clicked(target.x(), target.y());
            }
        }
    }

    /** Throws confetti, unless the player wants less motion. */
    public void celebrate(Motion motion) {
        if (motion == Motion.FULL) {
            spectacle.celebrate();
        }
    }

    public void draw(Canvas canvas, Motion motion) {
        PuzzleGame game = session.game();
        boolean isOwn = !session.isShowing();
        stage.draw(canvas, isOwn ? cursor.under(game) : Optional.empty(), spectacle);
        drawRefused(canvas, game, motion);
        spectacle.draw(canvas, camera, motion);
        game.balls().forEach(ball -> drawHold(canvas, ball, motion));
        cursor.chosen(game).ifPresent(target -> stage.drawChosen(canvas, target));
        session.show().ifPresent(show -> shownPointer.draw(canvas, show));
    }

    private void drawHold(Canvas canvas, RigidBody ball, Motion motion) {
        Pose pose = session.pose(ball);
        double radius = ball.shape().boundingRadius() * camera.scale() + RING_GAP;
        ring.draw(canvas, camera.screenX(pose.x()), camera.screenY(pose.y()), radius, motion);
    }

    /** Shakes the outline of a refused body at the place of the click. */
    private void drawRefused(Canvas canvas, PuzzleGame game, Motion motion) {
        if (refusal.is(Refusal.Reason.NOT_CLICKABLE)) {
            double aside = refusal.shake(motion);
            cursor.under(game)
                    .filter(Piece.class::isInstance)
                    .map(Piece.class::cast)
                    .ifPresent(piece -> stage.drawOutline(canvas, piece, aside));
        }
    }

    /** Draws the pointer's own marks above everything else: the cooldown and the cross. */
    public void drawPointer(Canvas canvas, Motion motion) {
        PuzzleGame game = session.game();
        if (!session.isShowing()) {
            drawVerb(canvas, game);
            CooldownRing.drawAtPointer(
                    canvas, cursor.x(game), cursor.y(game), game, refusal, motion);
        }
        refusal.draw(canvas);
        if (isChoosing && !session.isShowing()) {
            lens.draw(canvas, cursor.x(game), cursor.y(game), cursor.under(game));
        }
    }

    /**
     * Draws the sign of a click's action at the pointer; a target selected by keys shows it itself.
     * After the game is over no click has an effect, and the sign would cover the panel that says
     * so.
     */
    private void drawVerb(Canvas canvas, PuzzleGame game) {
        if (game.outcome() == Outcome.RUNNING && cursor.chosen(game).isEmpty()) {
            cursor.under(game)
                    .filter(Target::isClickable)
                    .ifPresent(
                            target ->
                                    Marks.drawAtPointer(
                                            canvas, target, cursor.x(game), cursor.y(game)));
        }
    }

    /** Handles a click at a point of the screen, px. */
    public void click(double x, double y) {
        PuzzleGame game = session.game();
        if (session.isShowing()) {
            refuse(Refusal.Reason.SHOWING, x, y);
            return;
        }
        double worldX = camera.worldX(x);
        double worldY = camera.worldY(y);
        Optional<Target> target = game.targetAt(worldX, worldY);
        OptionalDouble share = target.map(at -> share(at, worldX, worldY)).orElse(NOWHERE);
        ClickResult result = game.click(worldX, worldY);
        answer(result, x, y);
        if (result == ClickResult.DONE) {
            done(target.orElseThrow(), share);
        }
    }

    /** The place at which a click meets a rope, as a share of its length. */
    private static OptionalDouble share(Target target, double x, double y) {
        return target instanceof Link link && link.isRope() && link.isAlive()
                ? OptionalDouble.of(link.line().share(x, y))
                : NOWHERE;
    }

    private void done(Target target, OptionalDouble share) {
        noises.did(target);
        if (target instanceof Link link) {
            spectacle.cutting(link, share.orElse(Spectacle.MIDDLE));
        }
    }

    /** Clicks the target selected by keys; returns whether there is one. */
    public boolean clickChosen() {
        Optional<Target> chosen = cursor.chosen(session.game());
        if (session.isShowing() || chosen.isEmpty()) {
            return false;
        }
        double x = cursor.x(session.game());
        double y = cursor.y(session.game());
        ClickResult result = session.game().act(chosen.get().id());
        answer(result, x, y);
        if (result == ClickResult.DONE) {
            done(chosen.get(), NOWHERE);
            cursor.point(x, y);
        }
        return true;
    }

    /** Refuses a command by key, at the pointer. */
    public void refuse(Refusal.Reason why) {
        refuse(why, cursor.x(session.game()), cursor.y(session.game()));
    }

    private void refuse(Refusal.Reason why, double x, double y) {
        refusal.refuse(why, x, y);
        noises.refused();
    }

    private void answer(ClickResult result, double x, double y) {
        refusal.answer(result, x, y);
        switch (result) {
            case COOLING_DOWN, NO_CLICKS_LEFT, NOT_CLICKABLE -> noises.refused();
            case DONE, NOTHING_THERE, OVER -> {}
        }
    }

    /**
     * Describes all uncovered targets, and the level's start, to a screen reader.
     *
     * @param isCovered whether a panel lies over a point of the scene, px
     */
    public void describe(Narrator narrator, Words words, BiPredicate<Double, Double> isCovered) {
        PuzzleGame game = session.game();
        TargetNames names = new TargetNames(words, game);
        narrator.says(names.start());
        if (session.isShowing() || game.outcome() != Outcome.RUNNING) {
            return;
        }
        for (Target target : game.targets()) {
            // Removed targets have no place.
            if (target.isClickable()
                    && !isCovered.test(camera.screenX(target.x()), camera.screenY(target.y()))) {
                narrator.offers(control(target, names.of(target)));
            }
        }
    }

    private Control control(Target target, String name) {
        double left = camera.screenX(target.x()) - REACH;
        double top = camera.screenY(target.y()) - REACH;
        Control.Kind kind =
                target.is(Verb.SWITCH) ? Control.Kind.of(target.isOn()) : Control.Kind.BUTTON;
        boolean isChosen = cursor.chosen(session.game()).filter(target::equals).isPresent();
        return new Plate(left, top, 2 * REACH, 2 * REACH).control(name, kind, 0.5, isChosen);
    }

    public Refusal refusal() {
        return refusal;
    }

    public void point(double x, double y) {
        cursor.point(x, y);
    }

    /** Called when a finger begins or ends to choose. */
    public void choosing(boolean begins) {
        isChoosing = begins;
    }

    public void letGo() {
        cursor.letGo();
    }

    public void cycle(int direction) {
        cursor.cycle(session.game(), direction);
    }

    public void move(Key arrow) {
        cursor.move(session.game(), arrow);
    }
}
