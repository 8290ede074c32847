package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Length;
import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;

import tools.jackson.databind.JsonNode;

/**
 * E115: a chain is dynamic; E116: a body with a path is declared dynamic; E117: a path has a leg of
 * no length.
 */
final class PathRules {

    /** Least length of a leg, m: at a walking pace a shorter one takes less than a step. */
    static final double LEAST_WAY = 0.01;

    private PathRules() {}

    static void check(LevelSketch sketch) {
        for (Located<LevelBody> body : sketch.bodies()) {
            body.part().path().ifPresent(path -> check(sketch, body, path));
        }
    }

    /**
     * Whether a body of this type can have its shape: a chain has no mass, so it cannot be dynamic.
     */
    static boolean canBe(Document json, String pointer, Outline outline) {
        JsonNode body = json.node(pointer);
        boolean isDynamic = !body.has("path") && body.path("dynamic").asBoolean(true);
        boolean canBe = !(outline.shape() instanceof Chain && isDynamic);
        if (!canBe) {
            json.error(
                    pointer,
                    () ->
                            Fault.of(
                                    "E115",
                                    "E115 a chain has no mass: state \"dynamic\": false, or a"
                                            + " path"));
        }
        return canBe;
    }

    private static void check(LevelSketch sketch, Located<LevelBody> body, LevelPath path) {
        JsonNode stated = sketch.json().node(body.pointer() + "/dynamic");
        if (stated.asBoolean(false)) {
            sketch.json()
                    .error(
                            body.pointer() + "/dynamic",
                            () ->
                                    Fault.of(
                                            "E116",
                                            "E116 a body with a path is driven and cannot be"
                                                    + " dynamic"));
        }
        double x = body.part().x();
        double y = body.part().y();
        for (int i = 0; i < path.stops().size(); i++) {
            LevelPath.Stop stop = path.stops().get(i);
            requireWay(
                    sketch,
                    body.pointer() + "/path/points/" + i,
                    Length.hypot(stop.x() - x, stop.y() - y));
            x = stop.x();
            y = stop.y();
        }
    }

    private static void requireWay(LevelSketch sketch, String pointer, double metres) {
        if (metres < LEAST_WAY) {
            String words = "E117 a way of %.4f m, at least %.2f: it is where the body comes from";
            sketch.json().error(pointer, () -> Fault.of("E117", words, metres, LEAST_WAY));
        }
    }
}
