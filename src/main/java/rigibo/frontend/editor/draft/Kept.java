package rigibo.frontend.editor.draft;

import rigibo.backend.Geometry;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.puzzle.level.Outline;

import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A shape for which the editor has no tools: it can be moved and turned, and is otherwise kept as
 * the file states it.
 *
 * @param node as the file states it
 */
public record Kept(ObjectNode node) implements Form {

    /** Number of points around each part from which the outline is drawn. */
    private static final int POINTS = 32;

    /** Distance from a chain within which a point counts as on it, m. */
    private static final double NEAR = 0.2;

    private Optional<Outline> outline() {
        try {
            return Optional.of(Outline.of(node));
        } catch (IllegalArgumentException refused) {
            // A shape that is half written has no outline; the loader's message is shown beside it.
            return Optional.empty();
        }
    }

    /** Corners of the convex hull of all parts. */
    @Override
    public List<Point> corners() {
        return outline().map(Kept::corners).orElse(List.of());
    }

    private static List<Point> corners(Outline stated) {
        if (stated.shape() instanceof Chain chain) {
            return corners(chain);
        }
        Polygon band = Polygon.hull(rim(stated.shape()));
        double x = stated.centroidX() + band.centroidX();
        double y = stated.centroidY() + band.centroidY();
        List<Point> corners = new ArrayList<>();
        for (int i = 0; i < band.corners(); i++) {
            corners.add(new Point(x + band.cornerX(i), y + band.cornerY(i)));
        }
        return corners;
    }

    private static List<Point> corners(Chain chain) {
        List<Point> corners = new ArrayList<>();
        for (int i = 0; i < chain.corners(); i++) {
            corners.add(new Point(chain.cornerX(i), chain.cornerY(i)));
        }
        return corners;
    }

    /** Adds the farthest corner of each part in every direction, plus its rounding. */
    private static double[] rim(Shape shape) {
        double[] xy = new double[2 * POINTS * shape.parts()];
        int next = 0;
        for (int part = 0; part < shape.parts(); part++) {
            var outline = shape.outline(part);
            for (int i = 0; i < POINTS; i++) {
                double dx = Math.cos(2 * Math.PI * i / POINTS);
                double dy = Math.sin(2 * Math.PI * i / POINTS);
                int corner = 0;
                for (int j = 1; j < outline.corners(); j++) {
                    double more =
                            (outline.cornerX(j) - outline.cornerX(corner)) * dx
                                    + (outline.cornerY(j) - outline.cornerY(corner)) * dy;
                    corner = more > 0 ? j : corner;
                }
                xy[next++] = outline.cornerX(corner) + outline.radius() * dx;
                xy[next++] = outline.cornerY(corner) + outline.radius() * dy;
            }
        }
        return xy;
    }

    @Override
    public boolean contains(Point point) {
        if (outline().filter(stated -> stated.shape() instanceof Chain).isPresent()) {
            return isNearAnEdge(point);
        }
        return outline()
                .filter(
                        stated ->
                                Geometry.holds(
                                        stated.shape(),
                                        Placement.at(stated.centroidX(), stated.centroidY()),
                                        point.x(),
                                        point.y()))
                .isPresent();
    }

    /** A line has no inside, so it is grabbed where it can be seen. */
    private boolean isNearAnEdge(Point point) {
        List<Point> corners = corners();
        for (int i = 0; i + 1 < corners.size(); i++) {
            Point way = corners.get(i + 1).minus(corners.get(i));
            Point to = point.minus(corners.get(i));
            double along = to.x() * way.x() + to.y() * way.y();
            double share = Math.max(0, Math.min(1, along / (way.length() * way.length())));
            if (to.minus(way.times(share)).length() < NEAR) {
                return true;
            }
        }
        return false;
    }

    @Override
    public double reach() {
        return corners().stream().mapToDouble(Point::length).max().orElse(0);
    }

    @Override
    public Optional<Shape> shape() {
        return outline().map(Outline::shape);
    }

    @Override
    public Point centre() {
        return outline()
                .map(stated -> new Point(stated.centroidX(), stated.centroidY()))
                .orElse(new Point(0, 0));
    }
}
