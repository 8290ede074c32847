package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.frontend.document.Document;

import tools.jackson.databind.JsonNode;

import java.util.Locale;
import java.util.Optional;

/** Reads a body's shape; E110 where a polygon is not convex, E111 where its area is too small. */
final class OutlineRules {

    /** Smallest area of a polygon, m²: below it a body is thinner than contact can be kept. */
    static final double LEAST_AREA = 0.0025;

    private OutlineRules() {}

    /** The shape at this pointer, or nothing after telling what is wrong with it. */
    static Optional<Outline> read(Document level, String pointer) {
        JsonNode node = level.node(pointer);
        return switch (node.path("type").asString()) {
            case "box" -> Optional.of(centred(width(node, "w"), width(node, "h")));
            case "circle" -> Optional.of(new Outline(new Circle(width(node, "r")), 0, 0));
            default -> polygon(level, pointer + "/points");
        };
    }

    private static Outline centred(double width, double height) {
        return new Outline(Polygon.box(width, height), 0, 0);
    }

    private static double width(JsonNode node, String name) {
        return node.path(name).asDouble();
    }

    private static Optional<Outline> polygon(Document level, String pointer) {
        JsonNode points = level.node(pointer);
        double area = signedArea(points);
        if (!(Math.abs(area) >= LEAST_AREA)) {
            String small = "E111 area too small: %.4f m², at least %.4f";
            level.error(
                    pointer, () -> String.format(Locale.ROOT, small, Math.abs(area), LEAST_AREA));
            return Optional.empty();
        }
        int reflex = reflexCorner(points, Math.signum(area));
        if (reflex >= 0) {
            notConvex(level, pointer + "/" + reflex);
            return Optional.empty();
        }
        return build(level, pointer, area > 0 ? forwards(points) : backwards(points));
    }

    private static Optional<Outline> build(Document level, String pointer, double[] xy) {
        try {
            Polygon polygon = Polygon.of(xy);
            double centroidX = xy[0] - polygon.cornerX(0);
            double centroidY = xy[1] - polygon.cornerY(0);
            return Optional.of(new Outline(polygon, centroidX, centroidY));
        } catch (IllegalArgumentException refused) {
            // A star turns left at every corner, and only the engine sees that it goes round twice.
            level.error(pointer, () -> "E110 polygon not convex: " + refused.getMessage());
            return Optional.empty();
        }
    }

    private static void notConvex(Document level, String pointer) {
        JsonNode point = level.node(pointer);
        level.error(
                pointer,
                () ->
                        "E110 polygon not convex at the point ("
                                + point.path(0).asDouble()
                                + ", "
                                + point.path(1).asDouble()
                                + ")");
    }

    /** Shoelace sum, m²; positive counter-clockwise. */
    private static double signedArea(JsonNode points) {
        double twice = 0;
        for (int i = 0; i < points.size(); i++) {
            int next = (i + 1) % points.size();
            twice += x(points, i) * y(points, next) - x(points, next) * y(points, i);
        }
        return twice / 2;
    }

    /** The first corner that does not turn the way the polygon goes round, or -1. */
    private static int reflexCorner(JsonNode points, double direction) {
        int count = points.size();
        for (int i = 0; i < count; i++) {
            int before = (i + count - 1) % count;
            int after = (i + 1) % count;
            double ux = x(points, i) - x(points, before);
            double uy = y(points, i) - y(points, before);
            double wx = x(points, after) - x(points, i);
            double wy = y(points, after) - y(points, i);
            double sine = direction * (ux * wy - uy * wx) / Math.hypot(ux, uy) / Math.hypot(wx, wy);
            if (!(sine > LEAST_SINE)) {
                return i;
            }
        }
        return -1;
    }

    /** Flatter corners are the engine's to refuse as well; a millionth of a radian is no corner. */
    private static final double LEAST_SINE = 1e-6;

    private static double[] forwards(JsonNode points) {
        double[] xy = new double[2 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            xy[2 * i] = x(points, i);
            xy[2 * i + 1] = y(points, i);
        }
        return xy;
    }

    private static double[] backwards(JsonNode points) {
        int count = points.size();
        double[] xy = new double[2 * count];
        for (int i = 0; i < count; i++) {
            xy[2 * i] = x(points, count - 1 - i);
            xy[2 * i + 1] = y(points, count - 1 - i);
        }
        return xy;
    }

    private static double x(JsonNode points, int i) {
        return points.path(i).path(0).asDouble();
    }

    private static double y(JsonNode points, int i) {
        return points.path(i).path(1).asDouble();
    }
}
