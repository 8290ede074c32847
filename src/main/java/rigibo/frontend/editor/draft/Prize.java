package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.Solution;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The secret star of a draft: a feat, its sentence, and clicks that prove it. */
public final class Prize {

    /** The feats of level files, in the order in which they can be chosen. */
    public static final List<String> FEATS =
            List.of("clicks", "quick", "avoid", "touch", "keep", "clear", "inside", "first");

    /** Where a draft states its star. */
    public static final String STAR = "/star";

    private static final String SOLUTION = "solution";
    private static final String BODY = "body";
    private static final String JOINT = "joint";
    private static final String TEXT = "text";

    /** Seconds that are allowed at first. */
    private static final double QUICK = 10;

    private Prize() {}

    /** Whether a star can be stated: it is proved by a solution at first, until it has its own. */
    public static boolean canBe(Draft draft) {
        return draft.at("/solutions/0").isObject();
    }

    /** The feat of the star; empty if there is none. */
    public static Optional<String> feat(Draft draft) {
        return Optional.of(draft.at(STAR + "/type").asString("")).filter(FEATS::contains);
    }

    /**
     * Returns the draft with a star for another feat, or without one.
     *
     * @param text what the star says until its author says it better, by languages
     */
    public static Draft of(Draft draft, Optional<String> feat, ObjectNode text) {
        if (feat.isEmpty()) {
            return draft.without(STAR);
        }
        ObjectNode star = JsonNodeFactory.instance.objectNode();
        star.put("type", feat.get());
        switch (feat.get()) {
            case "clicks" -> star.put("count", draft.at("/rules/par").asInt(1));
            case "quick" -> star.put("seconds", QUICK);
            case "avoid", "touch", "keep" ->
                    star.put(BODY, targets(draft).stream().findFirst().orElse(""));
            case "first" -> star.put(BODY, first(draft));
            default -> {}
        }
        star.set(TEXT, text);
        JsonNode proof = draft.at(STAR + "/" + SOLUTION);
        star.set(SOLUTION, proof.isObject() ? proof : draft.at("/solutions/0"));
        Draft starred = draft.with(STAR, star).inFormatTwo();
        return feat.get().equals("first") ? aimed(starred, first(draft)) : starred;
    }

    private static String first(Draft draft) {
        return draft.at("/solutions/0/clicks/0")
                .path(BODY)
                .asString(draft.at("/solutions/0/clicks/0").path(JOINT).asString(""));
    }

    /** The bodies or joints that the feat is about; may be empty. */
    public static String target(Draft draft) {
        JsonNode star = draft.at(STAR);
        return star.path(BODY).asString(star.path(JOINT).asString(""));
    }

    /** The names that the feat can be about: bodies, and for the first click joints as well. */
    public static List<String> targets(Draft draft) {
        List<String> targets = new ArrayList<>();
        draft.items().stream()
                .filter(item -> item.kind() == Item.Kind.BODY)
                .forEach(item -> targets.add(item.id()));
        if (feat(draft).filter("first"::equals).isPresent()) {
            targets.addAll(JointEntry.ids(draft));
        }
        return targets;
    }

    /** Returns the draft with its star about another thing. */
    public static Draft aimed(Draft draft, String target) {
        Draft bare = draft.without(STAR + "/" + BODY).without(STAR + "/" + JOINT);
        String kind = JointEntry.ids(draft).contains(target) ? JOINT : BODY;
        return bare.with(STAR + "/" + kind, JsonNodeFactory.instance.stringNode(target));
    }

    /** Returns the draft with its star proved by these clicks. */
    public static Draft proved(Draft draft, Solution solution) {
        return draft.with(STAR + "/" + SOLUTION, Clicks.node(draft, solution));
    }
}
