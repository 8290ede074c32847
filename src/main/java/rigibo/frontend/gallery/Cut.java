package rigibo.frontend.gallery;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Placement;

import java.util.Arrays;
import java.util.Optional;

/**
 * Clips a convex outline to a window, one side of the window after another; round corners are
 * approximated by points (Sutherland and Hodgman, "Reentrant polygon clipping", 1974).
 */
final class Cut {

    /** Number of directions in which the outline's farthest point is computed. */
    private static final int DIRECTIONS = 48;

    /** Area below which a piece is not drawn, m². */
    private static final double SMALLEST = 1e-7;

    private double[] xy;
    private int count;

    /** Takes an outline at a position in the world. */
    Cut(Outline outline, Placement at) {
        double cos = Math.cos(at.angle());
        double sin = Math.sin(at.angle());
        xy = new double[2 * DIRECTIONS + 16];
        for (int i = 0; i < DIRECTIONS; i++) {
            double direction = 2 * Math.PI * i / DIRECTIONS;
            double dx = Math.cos(direction);
            double dy = Math.sin(direction);
            int corner = farthest(outline, dx, dy);
            double x = outline.cornerX(corner) + outline.radius() * dx;
            double y = outline.cornerY(corner) + outline.radius() * dy;
            add(at.x() + cos * x - sin * y, at.y() + sin * x + cos * y);
        }
    }

    private static int farthest(Outline outline, double dx, double dy) {
        int best = 0;
        for (int i = 1; i < outline.corners(); i++) {
            double more =
                    (outline.cornerX(i) - outline.cornerX(best)) * dx
                            + (outline.cornerY(i) - outline.cornerY(best)) * dy;
            best = more > 0 ? i : best;
        }
        return best;
    }

    private void add(double x, double y) {
        boolean isNew = count == 0 || x != xy[2 * count - 2] || y != xy[2 * count - 1];
        if (isNew) {
            xy[2 * count] = x;
            xy[2 * count + 1] = y;
            count++;
        }
    }

    /** Corners x₀, y₀, x₁, y₁, … of the part within a window, m; empty if that is too small. */
    Optional<double[]> inside(Aabb window) {
        keep(1, 0, window.maxX);
        keep(-1, 0, -window.minX);
        keep(0, 1, window.maxY);
        keep(0, -1, -window.minY);
        double[] piece = Arrays.copyOf(xy, 2 * count);
        return count > 2 && area() > SMALLEST ? Optional.of(piece) : Optional.empty();
    }

    /** Keeps the part with n·p ≤ most. */
    private void keep(double nx, double ny, double most) {
        double[] from = xy;
        int corners = count;
        xy = new double[2 * corners + 8];
        count = 0;
        for (int i = 0; i < corners; i++) {
            int next = (i + 1) % corners;
            double here = nx * from[2 * i] + ny * from[2 * i + 1] - most;
            double there = nx * from[2 * next] + ny * from[2 * next + 1] - most;
            if (here <= 0) {
                add(from[2 * i], from[2 * i + 1]);
            }
            if (here < 0 != there < 0 && here != there) {
                double share = here / (here - there);
                add(
                        from[2 * i] + share * (from[2 * next] - from[2 * i]),
                        from[2 * i + 1] + share * (from[2 * next + 1] - from[2 * i + 1]));
            }
        }
    }

    private double area() {
        double twice = 0;
        for (int i = 0; i < count; i++) {
            int next = (i + 1) % count;
            twice += xy[2 * i] * xy[2 * next + 1] - xy[2 * next] * xy[2 * i + 1];
        }
        return twice / 2;
    }
}
