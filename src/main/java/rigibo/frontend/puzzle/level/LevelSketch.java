package rigibo.frontend.puzzle.level;

import tools.jackson.databind.JsonNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * A level as far as its file could be read. A part with an error is left out, so that the rules
 * look at the others all the same and every error is told at once.
 *
 * @param json the document
 * @param world where it is sound
 * @param limits where they are sound
 * @param balls the sound ones
 * @param platform where it is sound
 * @param bodies the sound ones, in the file's order
 * @param solutions the sound ones, in the file's order
 */
record LevelSketch(
        LocatedJson json,
        Optional<Located<World>> world,
        Optional<Located<Limits>> limits,
        List<Located<Ball>> balls,
        Optional<Located<Platform>> platform,
        List<Located<LevelBody>> bodies,
        List<Located<Solution>> solutions) {

    /** Reads what the schema found sound; problems gains what the readers find. */
    static LevelSketch of(LocatedJson json, Problems problems) {
        return new LevelSketch(
                json,
                world(json, problems),
                part(json, "/rules", problems, LevelReader::limits),
                balls(json, problems),
                part(json, "/platform", problems, LevelReader::platform),
                bodies(json, problems),
                solutions(json, problems));
    }

    /** The whole level; call only when no problem is an error. */
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
                solutions.stream().map(Located::part).toList());
    }

    private static Optional<Located<World>> world(LocatedJson json, Problems problems) {
        try {
            return part(json, "/world", problems, LevelReader::world);
        } catch (IllegalArgumentException refused) {
            String pointer = "/world/effects";
            problems.error(json.at(pointer), pointer, refused.getMessage());
            return Optional.empty();
        }
    }

    private static List<Located<Ball>> balls(LocatedJson json, Problems problems) {
        List<Located<Ball>> balls = new ArrayList<>();
        part(json, "/ball", problems, node -> LevelReader.ball(Ball.FIRST, node))
                .ifPresent(balls::add);
        for (int i = 0; i < json.node("/moreBalls").size(); i++) {
            String name = Ball.named(i + 2);
            part(json, "/moreBalls/" + i, problems, node -> LevelReader.ball(name, node))
                    .ifPresent(balls::add);
        }
        return balls;
    }

    private static List<Located<LevelBody>> bodies(LocatedJson json, Problems problems) {
        List<Located<LevelBody>> bodies = new ArrayList<>();
        for (int i = 0; i < json.node("/bodies").size(); i++) {
            String pointer = "/bodies/" + i;
            if (!problems.spoil(pointer)) {
                OutlineRules.read(json, pointer + "/shape", problems)
                        .flatMap(
                                outline ->
                                        part(
                                                json,
                                                pointer,
                                                problems,
                                                node -> LevelReader.body(node, outline)))
                        .ifPresent(bodies::add);
            }
        }
        return bodies;
    }

    private static List<Located<Solution>> solutions(LocatedJson json, Problems problems) {
        List<Located<Solution>> solutions = new ArrayList<>();
        for (int i = 0; i < json.node("/solutions").size(); i++) {
            part(json, "/solutions/" + i, problems, LevelReader::solution)
                    .ifPresent(solutions::add);
        }
        return solutions;
    }

    private static <T> Optional<Located<T>> part(
            LocatedJson json, String pointer, Problems problems, Function<JsonNode, T> reader) {
        JsonNode node = json.node(pointer);
        return node.isMissingNode() || problems.spoil(pointer)
                ? Optional.empty()
                : Optional.of(new Located<>(pointer, json.at(pointer), reader.apply(node)));
    }
}
