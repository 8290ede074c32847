package rigibo.frontend.editor.draft;

import rigibo.backend.Geometry;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.puzzle.level.Outline;

import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Several convex parts in one body. It is moved and turned as a whole, and taken apart to change
 * them.
 *
 * @param node as the file states it
 */
public record Parts(ObjectNode node) implements Form {

    /** Number of points around each part from which its outline is drawn. */
    private static final int POINTS = 32;

    private Optional<Outline> outline() {
        try {
            return Optional.of(Outline.of(node));
        } catch (IllegalArgumentException refused) {
            // An incomplete shape has no outline; the loader's message is shown beside it.
            return Optional.empty();
        }
    }

    /** Corners of all parts. */
    @Override
    public List<Point> corners() {
        return lines().stream().flatMap(List::stream).toList();
    }

    @Override
    public List<List<Point>> lines() {
        return outline().map(Parts::lines).orElse(List.of());
    }

    private static List<List<Point>> lines(Outline stated) {
        Point centre = new Point(stated.centroidX(), stated.centroidY());
        List<List<Point>> lines = new ArrayList<>();
        for (int part = 0; part < stated.shape().parts(); part++) {
            Polygon band = Polygon.hull(rim(stated.shape().outline(part)));
            Point middle = centre.plus(new Point(band.centroidX(), band.centroidY()));
            List<Point> line = new ArrayList<>();
            for (int i = 0; i < band.corners(); i++) {
                line.add(middle.plus(new Point(band.cornerX(i), band.cornerY(i))));
            }
            lines.add(line);
        }
        return lines;
    }

    /** The farthest corner of a part in every direction, plus its rounding. */
    private static double[] rim(rigibo.backend.geometry.Outline part) {
        double[] xy = new double[2 * POINTS];
        for (int i = 0; i < POINTS; i++) {
            double dx = Math.cos(2 * Math.PI * i / POINTS);
            double dy = Math.sin(2 * Math.PI * i / POINTS);
            int corner = 0;
            for (int j = 1; j < part.corners(); j++) {
                double more =
                        (part.cornerX(j) - part.cornerX(corner)) * dx
                                + (part.cornerY(j) - part.cornerY(corner)) * dy;
                corner = more > 0 ? j : corner;
            }
            xy[2 * i] = part.cornerX(corner) + part.radius() * dx;
            xy[2 * i + 1] = part.cornerY(corner) + part.radius() * dy;
        }
        return xy;
    }

    @Override
    public boolean contains(Point point) {
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
