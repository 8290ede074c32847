package rigibo.frontend.puzzle;

import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.puzzle.rules.Deletion;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Settings.Motion;

import java.util.List;
import java.util.Optional;

/** The play area: the bodies, the rings, the particles, and the pointer over them. */
final class Table {

    /** Distance between the ball and its ring, px. */
    private static final double RING_GAP = 8;

    private final Session session;
    private final Camera camera;
    private final Noises noises;
    private final Stage stage;
    private final Cursor cursor;
    private final HoldRing ring;
    private final Refusal refusal = new Refusal();
    private final Spectacle spectacle;
    private ShownPointer shownPointer;

    /** The game that was on the screen in the last frame. */
    private PuzzleGame seen;

    Table(Session session, Camera camera, Noises noises) {
        this.session = session;
        this.camera = camera;
        this.noises = noises;
        seen = session.game();
        stage = new Stage(session, camera);
        spectacle = new Spectacle(session);
        cursor = new Cursor(camera);
        ring = new HoldRing(seen.level().limits().hold());
        shownPointer = new ShownPointer(camera);
    }

    /** One frame of 1/60 s. */
    void frame() {
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
            showDeletions(clicks);
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

    /** Handles what a show deleted in the last step. */
    private void showDeletions(int clicksBefore) {
        List<Deletion> deletions = seen.replay().deletions();
        for (Deletion deletion : deletions.subList(clicksBefore, deletions.size())) {
            seen.pieces().stream()
                    .filter(piece -> piece.definition().id().equals(deletion.body()))
                    .forEach(
                            piece -> {
                                Pose pose = session.lastPose(piece.body());
                                noises.deleted();
                                shownPointer.clicked(pose.x(), pose.y());
                            });
        }
    }

    /** Throws confetti, unless the player wants less motion. */
    void celebrate(Motion motion) {
        if (motion == Motion.FULL) {
            spectacle.celebrate();
        }
    }

    void draw(Canvas canvas, Motion motion) {
        PuzzleGame game = session.game();
        boolean isOwn = !session.isShowing();
        stage.draw(canvas, isOwn ? cursor.under(game) : Optional.empty(), spectacle);
        drawRefused(canvas, game, motion);
        spectacle.draw(canvas, motion);
        game.balls().forEach(ball -> drawHold(canvas, ball, motion));
        cursor.chosen(game).ifPresent(piece -> stage.drawChosen(canvas, piece));
        session.show().ifPresent(show -> shownPointer.draw(canvas, show));
    }

    private void drawHold(Canvas canvas, RigidBody ball, Motion motion) {
        Pose pose = session.pose(ball);
        double radius = ball.shape().boundingRadius() * camera.scale() + RING_GAP;
        ring.draw(canvas, camera.screenX(pose.x()), camera.screenY(pose.y()), radius, motion);
    }

    /** Shakes the outline of a body that cannot be deleted, where the click was. */
    private void drawRefused(Canvas canvas, PuzzleGame game, Motion motion) {
        if (refusal.is(Refusal.Reason.NOT_DELETABLE)) {
            double aside = refusal.shake(motion);
            cursor.under(game).ifPresent(piece -> stage.drawOutline(canvas, piece, aside));
        }
    }

    /** Draws what belongs to the pointer, above everything else: the cooldown and the cross. */
    void drawPointer(Canvas canvas, Motion motion) {
        PuzzleGame game = session.game();
        if (!session.isShowing()) {
            CooldownRing.drawAtPointer(
                    canvas, cursor.x(game), cursor.y(game), game, refusal, motion);
        }
        refusal.draw(canvas);
    }

    /** Handles a click at a point of the screen, px. */
    void click(double x, double y) {
        PuzzleGame game = session.game();
        if (session.isShowing()) {
            refuse(Refusal.Reason.SHOWING, x, y);
            return;
        }
        double worldX = camera.worldX(x);
        double worldY = camera.worldY(y);
        ClickResult result = game.click(worldX, worldY);
        answer(result, x, y);
        if (result == ClickResult.DELETED) {
            noises.deleted();
        }
    }

    /** Deletes the selected box; returns whether there is one. */
    boolean deleteChosen() {
        Optional<Piece> chosen = cursor.chosen(session.game());
        if (session.isShowing() || chosen.isEmpty()) {
            return false;
        }
        double x = cursor.x(session.game());
        double y = cursor.y(session.game());
        ClickResult result = session.game().delete(chosen.get().definition().id());
        answer(result, x, y);
        if (result == ClickResult.DELETED) {
            noises.deleted();
            cursor.point(x, y);
        }
        return true;
    }

    /** Refuses a command by key, at the pointer. */
    void refuse(Refusal.Reason why) {
        refuse(why, cursor.x(session.game()), cursor.y(session.game()));
    }

    private void refuse(Refusal.Reason why, double x, double y) {
        refusal.refuse(why, x, y);
        noises.refused();
    }

    private void answer(ClickResult result, double x, double y) {
        refusal.answer(result, x, y);
        switch (result) {
            case COOLING_DOWN, NO_CLICKS_LEFT, NOT_DELETABLE -> noises.refused();
            case DELETED, NOTHING_THERE, OVER -> {}
        }
    }

    Refusal refusal() {
        return refusal;
    }

    void point(double x, double y) {
        cursor.point(x, y);
    }

    void letGo() {
        cursor.letGo();
    }

    void cycle(int direction) {
        cursor.cycle(session.game(), direction);
    }

    void move(Key arrow) {
        cursor.move(session.game(), arrow);
    }
}
