package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Length;
import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;

import tools.jackson.databind.JsonNode;

import java.util.Optional;

/**
 * Reads a body's shape. E110: a polygon is not convex; E111: its area is too small; E112: a box
 * consists of hardly anything but round corners.
 */
final class OutlineRules {

    /** Least area of a polygon, m²: a smaller body is thinner than the depth that contacts keep. */
    static final double LEAST_AREA = 0.0025;

    /** Largest radius of a box's corners, a share of its smaller side: a flat part stays. */
    private static final double MOST_ROUND = 0.45;

    private OutlineRules() {}

    /** The shape at this pointer; empty after its error was reported. */
    static Optional<Outline> read(Document level, String pointer) {
        JsonNode node = level.node(pointer);
        boolean isSound =
                switch (node.path("type").asString()) {
                    case "box" -> keepsACore(level, pointer);
                    case "circle", "capsule", "chain" -> true;
                    case "compound" -> partsAreSound(level, pointer + "/parts");
                    default -> polygonIsSound(level, pointer + "/points");
                };
        return isSound ? build(level, pointer) : Optional.empty();
    }

    private static boolean keepsACore(Document level, String pointer) {
        JsonNode node = level.node(pointer);
        double smaller = Math.min(node.path("w").asDouble(), node.path("h").asDouble());
        double most = MOST_ROUND * smaller;
        double round = node.path("round").asDouble(0);
        if (round > most) {
            String large = "E112 corners too round: %.3f m, at most %.3f of a box %.3f m wide";
            level.error(pointer + "/round", () -> Fault.of("E112", large, round, most, smaller));
        }
        return round <= most;
    }

    /** Checks all parts, also those after a faulty one. */
    private static boolean partsAreSound(Document level, String pointer) {
        boolean areSound = true;
        for (int i = 0; i < level.node(pointer).size(); i++) {
            areSound &= read(level, pointer + "/" + i + "/shape").isPresent();
        }
        return areSound;
    }

    private static boolean polygonIsSound(Document level, String pointer) {
        JsonNode points = level.node(pointer);
        double area = Outline.signedArea(points);
        if (!(Math.abs(area) >= LEAST_AREA)) {
            String small = "E111 area too small: %.4f m², at least %.4f";
            level.error(pointer, () -> Fault.of("E111", small, Math.abs(area), LEAST_AREA));
            return false;
        }
        int reflex = reflexCorner(points, Math.signum(area));
        if (reflex >= 0) {
            notConvex(level, pointer + "/" + reflex);
        }
        return reflex < 0;
    }

    private static Optional<Outline> build(Document level, String pointer) {
        try {
            return Optional.of(Outline.of(level.node(pointer)));
        } catch (IllegalArgumentException refused) {
            // A star turns left at every corner, and only the engine sees that it goes round twice;
            // of a chain, the engine names the edges that are too short or cross.
            boolean isChain = level.node(pointer + "/type").asString("").equals("chain");
            String kind = isChain ? "E113" : "E110";
            String what = isChain ? "E113 no landscape: %s" : "E110 polygon not convex: %s";
            level.error(pointer + "/points", () -> Fault.of(kind, what, refused.getMessage()));
            return Optional.empty();
        }
    }

    private static void notConvex(Document level, String pointer) {
        JsonNode point = level.node(pointer);
        String words = "E110 polygon not convex at the point (%s, %s)";
        double x = point.path(0).asDouble();
        double y = point.path(1).asDouble();
        level.error(pointer, () -> Fault.of("E110", words, x, y));
    }

    /** The first corner that does not turn in the polygon's direction, or -1. */
    private static int reflexCorner(JsonNode points, double direction) {
        int count = points.size();
        for (int i = 0; i < count; i++) {
            int before = (i + count - 1) % count;
            int after = (i + 1) % count;
            double ux = x(points, i) - x(points, before);
            double uy = y(points, i) - y(points, before);
            double wx = x(points, after) - x(points, i);
            double wy = y(points, after) - y(points, i);
            double sine =
                    direction * (ux * wy - uy * wx) / Length.hypot(ux, uy) / Length.hypot(wx, wy);
            if (!(sine > LEAST_SINE)) {
                return i;
            }
        }
        return -1;
    }

    /**
     * Sine of the least angle of a corner, a millionth of a radian; the engine refuses flatter
     * ones, too.
     */
    private static final double LEAST_SINE = 1e-6;

    private static double x(JsonNode points, int i) {
        return points.path(i).path(0).asDouble();
    }

    private static double y(JsonNode points, int i) {
        return points.path(i).path(1).asDouble();
    }
}
