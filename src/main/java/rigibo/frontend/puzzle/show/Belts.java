package rigibo.frontend.puzzle.show;

import rigibo.backend.geometry.Outline;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.IdentityHashMap;
import java.util.Map;

/**
 * Chevrons that run round belts with their surface; while it stands still, they do too and are dim.
 */
final class Belts {

    /** Distance between two chevrons along the outline, m. */
    private static final double PITCH = 0.32;

    /** Depth of a chevron from the outline, half its length, and its width, m. */
    private static final double DEPTH = 0.13;

    private static final double HALF = 0.05;
    private static final double STROKE = 0.035;

    private static final Color RUNNING = Color.BRASS.alpha(0.9);
    private static final Color STANDING = Color.EDGE;

    /** Distance that each belt has run since its game began, m, counter-clockwise. */
    private final Map<Piece, Double> ways = new IdentityHashMap<>();

    void clear() {
        ways.clear();
    }

    /** Makes one step of 1/60 s. */
    void step(PuzzleGame game) {
        for (Piece piece : game.pieces()) {
            if (piece.isAlive() && piece.beltSpeed() != 0) {
                double speed = piece.body().material().surfaceSpeed();
                ways.merge(piece, speed * Steps.SECONDS, Double::sum);
            }
        }
    }

    void draw(Canvas canvas, Camera camera, Piece piece, Pose pose) {
        if (piece.beltSpeed() == 0) {
            return;
        }
        double[] ring = ring(piece.body().shape().outline(0));
        double length = length(ring);
        int count = Math.max(1, (int) Math.round(length / PITCH));
        double pitch = length / count;
        double begin = ((ways.getOrDefault(piece, 0.0) % pitch) + pitch) % pitch;
        double way = Math.signum(piece.beltSpeed());
        Color color = piece.isOn() ? RUNNING : STANDING;
        for (int i = 0; i < count; i++) {
            chevron(canvas, camera, pose, ring, begin + i * pitch, way, color);
        }
    }

    /** The outline as a closed ring of points x₀, y₀, x₁, …, counter-clockwise, m. */
    private static double[] ring(Outline outline) {
        if (outline.isDisc()) {
            return circle(outline.radius());
        }
        double[] ring = new double[2 * outline.corners()];
        for (int i = 0; i < outline.corners(); i++) {
            ring[2 * i] = outline.cornerX(i);
            ring[2 * i + 1] = outline.cornerY(i);
        }
        return ring;
    }

    private static double[] circle(double radius) {
        int corners = 24;
        double[] ring = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            ring[2 * i] = radius * Math.cos(2 * Math.PI * i / corners);
            ring[2 * i + 1] = radius * Math.sin(2 * Math.PI * i / corners);
        }
        return ring;
    }

    private static double edge(double[] ring, int i) {
        int next = (i + 2) % ring.length;
        return Math.hypot(ring[next] - ring[i], ring[next + 1] - ring[i + 1]);
    }

    private static double length(double[] ring) {
        double sum = 0;
        for (int i = 0; i < ring.length; i += 2) {
            sum += edge(ring, i);
        }
        return sum;
    }

    private static void chevron(
            Canvas canvas,
            Camera camera,
            Pose pose,
            double[] ring,
            double at,
            double way,
            Color color) {
        double left = at;
        int i = 0;
        while (i < ring.length - 2 && left > edge(ring, i)) {
            left -= edge(ring, i);
            i += 2;
        }
        double edge = edge(ring, i);
        int next = (i + 2) % ring.length;
        double dx = (ring[next] - ring[i]) / edge;
        double dy = (ring[next + 1] - ring[i + 1]) / edge;
        double x = ring[i] + left * dx;
        double y = ring[i + 1] + left * dy;
        // A counter-clockwise outline has its inside to the left.
        Pose tip =
                pose.at(x + way * HALF * dx - DEPTH / 2 * dy, y + way * HALF * dy + DEPTH / 2 * dx);
        Pose outer = pose.at(x - way * HALF * dx, y - way * HALF * dy);
        Pose inner = pose.at(x - way * HALF * dx - DEPTH * dy, y - way * HALF * dy + DEPTH * dx);
        line(canvas, camera, outer, tip, color);
        line(canvas, camera, inner, tip, color);
    }

    private static void line(Canvas canvas, Camera camera, Pose from, Pose to, Color color) {
        double width = STROKE * camera.scale();
        canvas.line(camera, from.x(), from.y(), to.x(), to.y(), width, color);
    }
}
