package rigibo.frontend.puzzle.show;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Placement;
import rigibo.backend.setup.Material;
import rigibo.frontend.puzzle.level.LevelPath;
import rigibo.frontend.puzzle.picture.Goal;
import rigibo.frontend.puzzle.picture.Skins;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.joint.JointPen;
import rigibo.frontend.scene.joint.JointPicture;

import java.util.Optional;

/** Draws the bodies of a level and marks the target of the pointer. */
final class Stage {

    /** Distance between a selected box and the corners drawn around it, px. */
    private static final double CORNER_GAP = 6;

    private static final double CORNER_LENGTH = 12;

    /** Half the width of a joint's sign, px. */
    private static final double SIGN = 14;

    /**
     * Radius of the dots along a driven body's path, the distance between two, and the radius of a
     * stop, px.
     */
    private static final double DOT = 2;

    private static final double DOT_PITCH = 12;
    private static final double STOP = 5;

    /** Half the width of a chevron on a one-way shelf, and the distance between two, px. */
    private static final double CHEVRON = 5;

    private static final double CHEVRON_PITCH = 22;
    private static final Color TRACK = Color.BRASS.alpha(0.55);

    private final Session session;
    private final Camera camera;
    private final Marks marks;
    private final Goal goal;
    private final Aabb bounds = new Aabb();

    Stage(Session session, Camera camera) {
        this.session = session;
        this.camera = camera;
        marks = new Marks(session, camera);
        goal = Goal.of(session.game().level());
    }

    /** Draws all bodies and joints; a clickable one under the pointer is lifted. */
    void draw(Canvas canvas, Optional<Target> meant, Spectacle spectacle) {
        PuzzleGame game = session.game();
        Pose ball = session.pose(game.balls().get(0));
        canvas.camera(camera);
        canvas.gaze(ball.x(), ball.y());
        goal.draw(canvas);
        for (Piece piece : game.pieces()) {
            if (piece.body().isAlive()) {
                boolean isMeant = piece.isClickable() && meant.filter(piece::equals).isPresent();
                Canvas.Mood mood = isMeant ? Canvas.Mood.HOVERED : spectacle.mood(piece);
                body(canvas, piece.body(), Skins.of(piece.substance()), mood);
                spectacle.drawOn(canvas, camera, piece);
            }
        }
        for (RigidBody each : game.balls()) {
            body(canvas, each, Skin.BALL, Canvas.Mood.PLAIN);
        }
        session.drawGhost(canvas);
        for (Piece piece : game.pieces()) {
            if (piece.isAlive()) {
                Streams.draw(canvas, camera, piece, game.steps());
            }
        }
        JointPicture.draw(canvas, camera, game.pool().joints(), this::placement);
        spectacle.drawRopes(new JointPen(canvas, camera));
        for (Piece piece : game.pieces()) {
            if (piece.body().isAlive()) {
                piece.definition().path().ifPresent(path -> drawPath(canvas, piece, path));
                drawWayThrough(canvas, piece);
            }
        }
        game.level()
                .world()
                .waterLevel()
                .ifPresent(level -> Water.draw(canvas, camera.screenY(level)));
        marks.draw(canvas, meant);
    }

    private Placement placement(RigidBody body) {
        Pose pose = session.pose(body);
        return new Placement(pose.x(), pose.y(), pose.angle());
    }

    /** Draws dots along the path of a driven body, and a ring at each of its stops. */
    private void drawPath(Canvas canvas, Piece piece, LevelPath path) {
        double x = piece.definition().x();
        double y = piece.definition().y();
        drawStop(canvas, x, y);
        for (LevelPath.Stop stop : path.stops()) {
            drawWay(canvas, x, y, stop.x(), stop.y());
            drawStop(canvas, stop.x(), stop.y());
            x = stop.x();
            y = stop.y();
        }
        if (path.end() == LevelPath.End.ROUND) {
            drawWay(canvas, x, y, piece.definition().x(), piece.definition().y());
        }
    }

    /** Draws chevrons over a one-way shelf, in the direction that it lets bodies pass. */
    private void drawWayThrough(Canvas canvas, Piece piece) {
        Material material = piece.definition().material();
        if (material.isOneWay()) {
            Pose pose = session.pose(piece.body());
            double cos = Math.cos(pose.angle());
            double sin = Math.sin(pose.angle());
            double upX = cos * material.oneWayX() - sin * material.oneWayY();
            double upY = -sin * material.oneWayX() - cos * material.oneWayY();
            double x = camera.screenX(pose.x());
            double y = camera.screenY(pose.y());
            for (int i = -1; i <= 1; i++) {
                double tipX = x + i * CHEVRON_PITCH * upY + CHEVRON * upX;
                double tipY = y - i * CHEVRON_PITCH * upX + CHEVRON * upY;
                chevron(canvas, tipX, tipY, upX, upY);
            }
        }
    }

    private static void chevron(Canvas canvas, double x, double y, double upX, double upY) {
        for (int side = -1; side <= 1; side += 2) {
            double footX = x + CHEVRON * (side * upY - upX);
            double footY = y - CHEVRON * (side * upX + upY);
            canvas.line(footX, footY, x, y, 2.5, Color.TEXT);
        }
    }

    private void drawStop(Canvas canvas, double x, double y) {
        canvas.ring(camera.screenX(x), camera.screenY(y), STOP, 2, 1, TRACK);
    }

    private void drawWay(Canvas canvas, double x, double y, double toX, double toY) {
        double length = Math.hypot(toX - x, toY - y) * camera.scale();
        int dots = (int) (length / DOT_PITCH);
        for (int i = 1; i < dots; i++) {
            double share = i / (double) dots;
            double dotX = x + share * (toX - x);
            double dotY = y + share * (toY - y);
            canvas.disc(camera.screenX(dotX), camera.screenY(dotY), DOT, TRACK);
        }
    }

    private void body(Canvas canvas, RigidBody body, Skin skin, Canvas.Mood mood) {
        Pose pose = session.pose(body);
        canvas.body(body.shape(), pose.x(), pose.y(), pose.angle(), skin, mood);
    }

    /** Draws the outline of a body shifted a little, px. */
    void drawOutline(Canvas canvas, Piece piece, double aside) {
        Pose pose = session.pose(piece.body());
        canvas.body(
                piece.body().shape(),
                pose.x() + aside / camera.scale(),
                pose.y(),
                pose.angle(),
                Skins.of(piece.substance()),
                Canvas.Mood.GHOST);
    }

    /** Draws four corners around the target selected by keys. */
    void drawChosen(Canvas canvas, Target target) {
        if (target instanceof Piece piece) {
            Pose pose = session.pose(piece.body());
            double cos = Math.cos(pose.angle());
            double sin = Math.sin(pose.angle());
            piece.body().shape().bounds(pose.x(), pose.y(), cos, sin, bounds);
        } else {
            double half = SIGN / camera.scale();
            bounds.set(target.x() - half, target.y() - half, target.x() + half, target.y() + half);
        }
        double left = camera.screenX(bounds.minX) - CORNER_GAP;
        double right = camera.screenX(bounds.maxX) + CORNER_GAP;
        double top = camera.screenY(bounds.maxY) - CORNER_GAP;
        double bottom = camera.screenY(bounds.minY) + CORNER_GAP;
        corner(canvas, left, top, CORNER_LENGTH, CORNER_LENGTH);
        corner(canvas, right, top, -CORNER_LENGTH, CORNER_LENGTH);
        corner(canvas, left, bottom, CORNER_LENGTH, -CORNER_LENGTH);
        corner(canvas, right, bottom, -CORNER_LENGTH, -CORNER_LENGTH);
    }

    private static void corner(Canvas canvas, double x, double y, double across, double down) {
        canvas.line(x, y, x + across, y, 3, Color.TEXT);
        canvas.line(x, y, x, y + down, 3, Color.TEXT);
    }
}
