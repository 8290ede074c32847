package rigibo.frontend.puzzle.level;

import tools.jackson.databind.JsonNode;

/** Turns a star that the schema accepts into a record. */
final class StarReader {

    private StarReader() {}

    static Star star(JsonNode node) {
        return new Star(
                LevelReader.wording(node.path("text")),
                feat(node),
                LevelReader.solution(node.path("solution")));
    }

    private static Feat feat(JsonNode node) {
        String body = node.path("body").asString("");
        String type = node.path("type").asString();
        return switch (type) {
            case "clicks" -> new Feat.Clicks(node.path("count").asInt());
            case "quick" -> new Feat.Quick(node.path("seconds").asDouble());
            case "avoid" ->
                    node.has("body")
                            ? new Feat.AvoidBody(body)
                            : new Feat.AvoidMaterial(
                                    Substance.titled(node.path("material").asString()));
            case "touch" -> new Feat.Touch(body);
            case "keep" -> new Feat.Keep(body);
            case "clear" -> new Feat.Clear();
            case "inside" -> new Feat.Inside();
            case "first" -> new Feat.First(Click.targetIn(node));
            default -> throw new IllegalArgumentException("no star is of the type " + type);
        };
    }
}
