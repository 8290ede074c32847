package rigibo.frontend.puzzle.show;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.puzzle.rules.Link;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

import java.util.Optional;

/**
 * A magnifier for a finger among targets smaller than itself. It shows the outlines below the
 * finger, above the finger, with the target of a click lit.
 */
final class Lens {

    /** Its side, and the distance from the finger to its lower edge, in fingers. */
    private static final double SIDE = 3.2;

    private static final double ABOVE = 1;

    private static final double ZOOM = 2.4;

    /** Number of directions in which a round outline is followed, for each half turn. */
    private static final int DIRECTIONS = 24;

    private static final double LINE = 2.5;
    private static final double LIT_LINE = 6;

    private final Session session;
    private final Camera camera;
    private final Clip clip = new Clip();
    private Canvas canvas;
    private double middleX;
    private double middleY;
    private double worldX;
    private double worldY;

    Lens(Session session, Camera camera) {
        this.session = session;
        this.camera = camera;
    }

    /** Draws it for a finger at a point of the screen, px, if a small target is near. */
    void draw(Canvas on, double x, double y, Optional<Target> meant) {
        Layout layout = on.layout();
        double finger = layout.clickable(0);
        if (!isAmongSmallThings(x, y, finger)) {
            return;
        }
        canvas = on;
        double half = SIDE * finger / 2;
        middleX = Math.max(layout.seenLeft() + half, Math.min(layout.seenRight() - half, x));
        double above = y - ABOVE * finger - half;
        middleY = above - half < layout.seenTop() ? y + ABOVE * finger + half : above;
        worldX = camera.worldX(x);
        worldY = camera.worldY(y);
        clip.to(middleX - half, middleY - half, middleX + half, middleY + half);
        canvas.panel(middleX - half, middleY - half, 2 * half, 2 * half, 16, Color.NIGHT);
        drawAll(session.game(), meant);
        canvas.frame(middleX - half, middleY - half, 2 * half, 2 * half, 16, Color.BRASS);
        double mark = finger / 6;
        canvas.line(middleX - mark, middleY, middleX + mark, middleY, 2, Color.TEXT);
        canvas.line(middleX, middleY - mark, middleX, middleY + mark, 2, Color.TEXT);
    }

    private void drawAll(PuzzleGame game, Optional<Target> meant) {
        outline(game.platform(), Color.GOOD, LINE);
        game.balls().forEach(ball -> outline(ball, Color.TEXT, LINE));
        for (Target target : game.targets()) {
            boolean isMeant = target.isClickable() && meant.filter(target::equals).isPresent();
            Color color = target.isClickable() ? Color.RIGIBO : Color.TEXT_DIM;
            draw(target, isMeant ? Color.BRASS : color, isMeant ? LIT_LINE : LINE);
        }
    }

    private void draw(Target target, Color color, double width) {
        if (target instanceof Piece piece && piece.body().isAlive()) {
            outline(piece.body(), color, width);
        } else if (target instanceof Link link && link.isAlive()) {
            draw(link, color, width);
        }
    }

    private void draw(Link link, Color color, double width) {
        if (link.isRope()) {
            double[] xy = link.line().points();
            for (int i = 2; i < xy.length; i += 2) {
                line(xy[i - 2], xy[i - 1], xy[i], xy[i + 1], color, width);
            }
        } else if (clip.holds(lensX(link.x()), lensY(link.y()))) {
            canvas.ring(lensX(link.x()), lensY(link.y()), 4 * LINE, width, 1, color);
        }
    }

    private void outline(RigidBody body, Color color, double width) {
        Shape shape = body.shape();
        Pose pose = session.pose(body);
        for (int part = 0; part < shape.parts(); part++) {
            outline(shape.outline(part), pose, color, width);
        }
    }

    /** Follows an outline by its farthest points in all directions. */
    private void outline(Outline outline, Pose pose, Color color, double width) {
        double lastX = 0;
        double lastY = 0;
        for (int i = 0; i <= 2 * DIRECTIONS; i++) {
            double angle = Math.PI * i / DIRECTIONS;
            double x = farthestX(outline, angle);
            double y = farthestY(outline, angle);
            double toX = pose.x() + x * Math.cos(pose.angle()) - y * Math.sin(pose.angle());
            double toY = pose.y() + x * Math.sin(pose.angle()) + y * Math.cos(pose.angle());
            if (i > 0 && (toX != lastX || toY != lastY)) {
                line(lastX, lastY, toX, toY, color, width);
            }
            lastX = toX;
            lastY = toY;
        }
    }

    private static double farthestX(Outline outline, double angle) {
        return outline.cornerX(farthest(outline, angle)) + outline.radius() * Math.cos(angle);
    }

    private static double farthestY(Outline outline, double angle) {
        return outline.cornerY(farthest(outline, angle)) + outline.radius() * Math.sin(angle);
    }

    private static int farthest(Outline outline, double angle) {
        int farthest = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < outline.corners(); i++) {
            double along =
                    outline.cornerX(i) * Math.cos(angle) + outline.cornerY(i) * Math.sin(angle);
            if (along > most) {
                most = along;
                farthest = i;
            }
        }
        return farthest;
    }

    private void line(
            double fromX, double fromY, double toX, double toY, Color color, double width) {
        if (clip.cut(lensX(fromX), lensY(fromY), lensX(toX), lensY(toY))) {
            canvas.line(clip.fromX, clip.fromY, clip.toX, clip.toY, width, color);
        }
    }

    private double lensX(double x) {
        return middleX + (x - worldX) * camera.scale() * ZOOM;
    }

    private double lensY(double y) {
        return middleY - (y - worldY) * camera.scale() * ZOOM;
    }

    /** Whether a finger at a point, px, could mean a target smaller than itself. */
    private boolean isAmongSmallThings(double x, double y, double finger) {
        return session.game().targets().stream()
                .filter(Target::isClickable)
                .filter(target -> isSmall(target, finger))
                .anyMatch(target -> isNear(target, x, y, finger));
    }

    private boolean isSmall(Target target, double finger) {
        return !(target instanceof Piece piece)
                || piece.body().shape().smallestWidth() * camera.scale() < finger;
    }

    private boolean isNear(Target target, double x, double y, double finger) {
        double reach =
                target instanceof Piece piece
                        ? piece.body().shape().boundingRadius() * camera.scale()
                        : 0;
        double away = Math.hypot(camera.screenX(target.x()) - x, camera.screenY(target.y()) - y);
        return away < reach + finger / 2;
    }
}
