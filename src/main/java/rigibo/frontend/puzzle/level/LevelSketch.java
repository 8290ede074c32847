package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;

import tools.jackson.databind.JsonNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * The parts of a level that could be read. A part with an error is left out, so that the rules
 * still check the others and all errors are reported at once.
 *
 * @param json the document
 * @param world empty if it has an error
 * @param limits empty if they have an error
 * @param balls those without errors
 * @param platform empty if it has an error
 * @param bodies those without errors, in the file's order
 * @param joints those without errors, in the file's order
 * @param solutions those without errors, in the file's order
 * @param star empty if there is none or it has an error
 */
record LevelSketch(
        Document json,
        Optional<Located<World>> world,
        Optional<Located<Limits>> limits,
        List<Located<Ball>> balls,
        Optional<Located<Platform>> platform,
        List<Located<LevelBody>> bodies,
        List<Located<LevelJoint>> joints,
        List<Located<Solution>> solutions,
        Optional<Located<Star>> star) {

    /** Pointer of a file's star. */
    static final String STAR = "/star";

    /** Reads the parts that the schema accepts; the readers report errors. */
    static LevelSketch of(Document json) {
        return new LevelSketch(
                json,
                world(json),
                part(json, "/rules", LevelReader::limits),
                balls(json),
                part(json, "/platform", LevelReader::platform),
                bodies(json),
                joints(json),
                solutions(json),
                part(json, STAR, StarReader::star));
    }

    /** The whole level; must be called only if there is no error. */
    Level level() {
        JsonNode root = json.root();
        return new Level(
                root.path("id").asString(),
                LevelReader.wording(root.path("title")),
                LevelReader.wording(root.path("hint")),
                world.orElseThrow().part(),
                limits.orElseThrow().part(),
                balls.stream().map(Located::part).toList(),
                platform.orElseThrow().part(),
                bodies.stream().map(Located::part).toList(),
                joints.stream().map(Located::part).toList(),
                solutions.stream().map(Located::part).toList(),
                star.map(Located::part),
                Optional.empty());
    }

    /** All sequences of clicks that should win: the solutions, and the star's. */
    List<Located<Solution>> ways() {
        List<Located<Solution>> ways = new ArrayList<>(solutions);
        star.ifPresent(one -> ways.add(new Located<>(STAR + "/solution", one.part().solution())));
        return ways;
    }

    private static Optional<Located<World>> world(Document json) {
        try {
            return part(json, "/world", LevelReader::world);
        } catch (IllegalArgumentException refused) {
            String pointer = "/world/effects";
            json.error(pointer, () -> Fault.of("schema", "%s", refused.getMessage()));
            return Optional.empty();
        }
    }

    private static List<Located<Ball>> balls(Document json) {
        List<Located<Ball>> balls = new ArrayList<>();
        part(json, "/ball", node -> LevelReader.ball(Ball.FIRST, node)).ifPresent(balls::add);
        for (int i = 0; i < json.node("/moreBalls").size(); i++) {
            String name = Ball.named(i + 2);
            part(json, "/moreBalls/" + i, node -> LevelReader.ball(name, node))
                    .ifPresent(balls::add);
        }
        return balls;
    }

    private static List<Located<LevelBody>> bodies(Document json) {
        List<Located<LevelBody>> bodies = new ArrayList<>();
        for (int i = 0; i < json.node("/bodies").size(); i++) {
            String pointer = "/bodies/" + i;
            if (!json.isSpoilt(pointer)) {
                OutlineRules.read(json, pointer + "/shape")
                        .filter(outline -> PathRules.canBe(json, pointer, outline))
                        .flatMap(
                                outline ->
                                        part(
                                                json,
                                                pointer,
                                                node -> LevelReader.body(node, outline)))
                        .ifPresent(bodies::add);
            }
        }
        return bodies;
    }

    private static List<Located<LevelJoint>> joints(Document json) {
        List<Located<LevelJoint>> joints = new ArrayList<>();
        for (int i = 0; i < json.node("/joints").size(); i++) {
            part(json, "/joints/" + i, JointReader::joint).ifPresent(joints::add);
        }
        return joints;
    }

    private static List<Located<Solution>> solutions(Document json) {
        List<Located<Solution>> solutions = new ArrayList<>();
        for (int i = 0; i < json.node("/solutions").size(); i++) {
            part(json, "/solutions/" + i, LevelReader::solution).ifPresent(solutions::add);
        }
        return solutions;
    }

    private static <T> Optional<Located<T>> part(
            Document json, String pointer, Function<JsonNode, T> reader) {
        JsonNode node = json.node(pointer);
        return node.isMissingNode() || json.isSpoilt(pointer)
                ? Optional.empty()
                : Optional.of(new Located<>(pointer, reader.apply(node)));
    }
}
