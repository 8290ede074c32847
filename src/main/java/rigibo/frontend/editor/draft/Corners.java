package rigibo.frontend.editor.draft;

import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;

/**
 * A polygon of given corners, in either direction, convex or not.
 *
 * @param corners m
 */
public record Corners(List<Point> corners) implements Form {

    /** Fewest and most corners of a polygon in a level file. */
    public static final int FEWEST = 3;

    public static final int MOST = 16;

    public Corners {
        corners = List.copyOf(corners);
    }

    /** A body's {@code points}. */
    static Corners of(JsonNode points) {
        List<Point> corners = new ArrayList<>();
        for (JsonNode point : points) {
            corners.add(new Point(Decimal.read(point.path(0), 0), Decimal.read(point.path(1), 0)));
        }
        return new Corners(corners);
    }

    /**
     * A regular polygon that stands on an edge; its corners are {@code radius} m from its middle.
     */
    public static Corners regular(int count, double radius) {
        List<Point> corners = new ArrayList<>();
        double turn = 360.0 / count;
        for (int i = 0; i < count; i++) {
            corners.add(new Point(0, -radius).turned(turn * (i + 0.5)));
        }
        return new Corners(corners);
    }

    /**
     * Even–odd rule: a point is inside if a ray to the right crosses the outline an odd number of
     * times.
     */
    @Override
    public boolean contains(Point point) {
        boolean isInside = false;
        for (int i = 0; i < corners.size(); i++) {
            Point a = corners.get(i);
            Point b = corners.get((i + 1) % corners.size());
            boolean isCrossed = a.y() > point.y() != b.y() > point.y();
            if (isCrossed
                    && point.x()
                            < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
                isInside = !isInside;
            }
        }
        return isInside;
    }

    @Override
    public double reach() {
        return corners.stream().mapToDouble(Point::length).max().orElse(0);
    }

    @Override
    public Optional<Shape> shape() {
        return polygon().map(polygon -> polygon);
    }

    @Override
    public Point centre() {
        List<Point> round = counterClockwise();
        return polygon()
                .map(made -> round.get(0).minus(new Point(made.cornerX(0), made.cornerY(0))))
                .orElse(new Point(0, 0));
    }

    private double[] xy() {
        return counterClockwise().stream()
                .flatMapToDouble(point -> DoubleStream.of(point.x(), point.y()))
                .toArray();
    }

    /** Whether it must be cut into convex parts to be simulated, and can be. */
    public boolean isConcave() {
        return whole() instanceof Parts;
    }

    /**
     * Returns this outline if it is convex, otherwise its convex parts. An outline that crosses
     * itself, or has more parts than a file may state, is returned unchanged.
     */
    public Form whole() {
        if (polygon().isPresent()) {
            return this;
        }
        try {
            Compound cut = Compound.ofOutline(xy());
            List<Corners> parts = new ArrayList<>();
            for (int i = 0; i < cut.parts(); i++) {
                parts.add(corners(cut.part(i)));
            }
            return parts.size() <= MOST ? new Parts(Gluing.compound(parts)) : this;
        } catch (IllegalArgumentException refused) {
            // An outline that crosses itself stays unchanged; the loader's message is shown beside
            // it.
            return this;
        }
    }

    private static Corners corners(Part part) {
        Polygon piece = (Polygon) part.shape();
        List<Point> corners = new ArrayList<>();
        for (int i = 0; i < piece.corners(); i++) {
            corners.add(new Point(part.x() + piece.cornerX(i), part.y() + piece.cornerY(i)));
        }
        return new Corners(corners);
    }

    private Optional<Polygon> polygon() {
        try {
            return Optional.of(Polygon.of(xy()));
        } catch (IllegalArgumentException refused) {
            // A polygon that is half drawn or not convex is shown as an outline, beside the
            // loader's message.
            return Optional.empty();
        }
    }

    /** The corners in counter-clockwise order. */
    List<Point> counterClockwise() {
        double twiceArea = 0;
        for (int i = 0; i < corners.size(); i++) {
            twiceArea += corners.get(i).cross(corners.get((i + 1) % corners.size()));
        }
        List<Point> round = new ArrayList<>(corners);
        if (twiceArea < 0) {
            Collections.reverse(round);
        }
        return round;
    }

    /** Returns this polygon with a corner at another place. */
    public Corners with(int corner, Point place) {
        List<Point> changed = new ArrayList<>(corners);
        changed.set(corner, place);
        return new Corners(changed);
    }

    @Override
    public ObjectNode node() {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("type", "polygon");
        ArrayNode points = node.putArray("points");
        for (Point corner : corners) {
            points.add(JointEntry.node(corner));
        }
        return node;
    }
}
