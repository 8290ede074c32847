package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Leaf;
import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Grid;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.puzzle.level.Limits;
import rigibo.frontend.puzzle.level.World;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

/** The fields of the level as a whole, shown while nothing is selected. */
final class LevelPane {

    private static final Fields.Range SIZE = new Fields.Range(1, 100, 0.5, 1);
    private static final Fields.Range PULL = new Fields.Range(-100, 100, 0.1, 0);
    private static final Fields.Range WATER = new Fields.Range(0, 100, 0.1, 0);
    private static final Fields.Range PAR = new Fields.Range(1, 50, 1, 1);
    private static final Fields.Range COOLDOWN = new Fields.Range(0, 10, 0.1, 0);
    private static final Fields.Range HOLD = new Fields.Range(0.1, 30, 0.1, 0.1);
    private static final Fields.Range CLICKS = new Fields.Range(0, 1000, 1, 0);

    private static final Fields.Range TIME = new Fields.Range(0, 3600, 5, 0);
    private static final Fields.Range GRACE = new Fields.Range(0, 1, 0.05, Limits.USUAL_GRACE);
    private static final Fields.Range WATER_DENSITY =
            new Fields.Range(1, 100_000, 50, World.USUAL_WATER);
    private static final Fields.Range WATER_DRAG = new Fields.Range(0, 100, 0.5, World.USUAL_DRAG);

    private LevelPane() {}

    static void draw(Fields fields) {
        Leaf leaf = fields.desk().levelLeaf();
        fields.leaves(Leaf.OF_LEVEL, leaf);
        switch (leaf) {
            case RULES -> rules(fields);
            case STAR -> StarPane.draw(fields);
            default -> level(fields);
        }
    }

    private static void level(Fields fields) {
        wording(fields, "title", "/title");
        wording(fields, "hint", "/hint");
        fields.number("width", "/world/width", SIZE);
        fields.number("height", "/world/height", SIZE);
        fields.number("pull.x", "/world/gravity/0", PULL);
        fields.number("pull.y", "/world/gravity/1", PULL);
        water(fields);
        fields.column()
                .toggle(
                        fields.words("grid"),
                        fields.desk().grid() == Grid.ON,
                        fields.words("grid.told"),
                        fields.desk()::switchGrid);
    }

    private static void rules(Fields fields) {
        Draft draft = fields.desk().draft();
        fields.count("par", "/rules/par", PAR);
        fields.limit("clicks", "/rules/maxClicks", CLICKS);
        fields.stated("time", "/rules/timeLimit", TIME);
        fields.number("cooldown", "/rules/cooldown", COOLDOWN);
        fields.number("hold", "/rules/hold", HOLD);
        fields.number("grace", "/rules/contactGrace", GRACE);
        int solutions = draft.at("/solutions").size();
        if (solutions > 0) {
            fields.column()
                    .button(
                            fields.words("forget", solutions),
                            fields.words("forget.told"),
                            () -> fields.desk().change(draft.without("/solutions")));
        }
    }

    /** Level files state water with its surface, or none at all. */
    private static void water(Fields fields) {
        String pointer = "/world/water/level";
        fields.number(
                "water",
                pointer,
                WATER,
                (draft, surface) ->
                        surface > 0
                                ? draft.with(pointer, Decimal.of(surface))
                                : draft.without("/world/water"));
        if (fields.desk().draft().at(pointer).isNumber()) {
            fields.stated("water.density", "/world/water/density", WATER_DENSITY);
            fields.stated("water.drag", "/world/water/drag", WATER_DRAG);
        }
    }

    /** In the player's language; in English too as long as nothing else is there. */
    static void wording(Fields fields, String key, String member) {
        String language = fields.language();
        String pointer = member + "/" + language;
        String english = member + "/en";
        String stated = fields.desk().draft().at(pointer).asString(englishOf(fields, english));
        String held = stated.equals(NewLevel.TITLE) ? fields.words("untitled") : stated;
        fields.column().note(fields.words(key));
        fields.text(
                pointer,
                key,
                held,
                typed -> {
                    Draft draft = fields.desk().draft();
                    if (typed.isBlank() || typed.equals(held)) {
                        return;
                    }
                    String before = draft.at(english).asString("");
                    boolean isUntitled = before.equals(NewLevel.TITLE);
                    Draft bare =
                            isUntitled
                                    ? draft.with(member, JsonNodeFactory.instance.objectNode())
                                    : draft;
                    Draft worded = bare.with(pointer, text(typed));
                    fields.desk()
                            .change(
                                    isUntitled || before.isEmpty()
                                            ? worded.with(english, text(typed))
                                            : worded);
                });
    }

    private static String englishOf(Fields fields, String pointer) {
        return fields.desk().draft().at(pointer).asString("");
    }

    private static JsonNode text(String words) {
        return JsonNodeFactory.instance.stringNode(words);
    }
}
