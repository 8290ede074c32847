package rigibo.frontend.puzzle.generate;

import rigibo.frontend.puzzle.level.LevelText;
import rigibo.frontend.puzzle.level.Solution;

import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;

/** Writes a plan as a level file. */
final class Sheet {

    private static final List<String> EFFECTS =
            List.of(
                    "gravity",
                    "contacts",
                    "friction",
                    "restitution",
                    "rolling-resistance",
                    "rotation",
                    "continuous-impacts",
                    "sleep");

    private final long seed;
    private final Plan plan;

    Sheet(long seed, Plan plan) {
        this.seed = seed;
        this.plan = plan;
    }

    /** The file without a solution. */
    String text() {
        return LevelText.of(document());
    }

    /** The file with a solution. */
    String text(Solution solution) {
        ObjectNode level = document();
        ArrayNode clicks = level.withArray("solutions").addObject().putArray("clicks");
        solution.clicks()
                .forEach(
                        click ->
                                clicks.addObject()
                                        .put("t", click.seconds())
                                        .put("body", click.target()));
        return LevelText.of(level);
    }

    private ObjectNode document() {
        String number = Long.toString(seed);
        ObjectNode level = JsonNodeFactory.instance.objectNode();
        level.put("$schema", "./level.schema.json").put("format", 1).put("id", "seed-" + number);
        level.putObject("title").put("en", "No. " + number).put("de", "Nr. " + number);
        level.putObject("hint")
                .put("en", "Look along the ball's way before you let it go.")
                .put("de", "Sieh dir den Weg des Balls an, bevor du ihn loslässt.");
        ObjectNode world =
                level.putObject("world").put("width", Plan.WIDTH).put("height", Plan.HEIGHT);
        world.putArray("gravity").add(0.0).add(-9.81);
        ArrayNode effects = world.putArray("effects");
        EFFECTS.forEach(effects::add);
        level.putObject("rules")
                .put("cooldown", 1.0)
                .put("hold", 3.0)
                .put("contactGrace", 0.25)
                .put("par", Math.max(1, plan.clicks().size()));
        level.setAll(plan.document());
        level.putArray("solutions");
        return level;
    }
}
