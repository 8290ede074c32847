package rigibo.frontend.editor.draft;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * The draft with which an author starts: a world of the window's size, a ball on a ledge, a
 * platform.
 */
public final class NewLevel {

    /** Title of a level until its author changes it, in English. */
    public static final String TITLE = "New level";

    /** The id until the level is saved for the first time. */
    public static final String ID = "new-level";

    private NewLevel() {}

    /** A draft of it. */
    public static Draft draft() {
        return Draft.of(document());
    }

    static ObjectNode document() {
        ObjectNode level = JsonNodeFactory.instance.objectNode();
        level.put("format", 2).put("id", ID);
        level.putObject("title").put("en", TITLE).put("de", "Neues Level");
        world(level.putObject("world"));
        level.putObject("rules")
                .put("cooldown", 1.0)
                .put("hold", 3.0)
                .put("contactGrace", 0.25)
                .put("par", 1);
        level.putObject("ball")
                .put("x", 2.0)
                .put("y", 2.55)
                .put("radius", 0.35)
                .put("material", "ball");
        level.putObject("platform").put("x", 7.0).put("y", 1.2).put("w", 2.0).put("h", 0.3);
        ledge(level.putArray("bodies").addObject());
        level.putArray("solutions");
        return level;
    }

    private static void world(ObjectNode world) {
        world.put("width", 9.0).put("height", 10.0);
        world.putArray("gravity").add(0.0).add(-9.81);
        world.putArray("effects")
                .add("gravity")
                .add("contacts")
                .add("rotation")
                .add("friction")
                .add("restitution")
                .add("rolling-resistance")
                .add("continuous-impacts")
                .add("sleep");
    }

    private static void ledge(ObjectNode ledge) {
        ledge.put("id", "ledge");
        ledge.putObject("shape").put("type", "box").put("w", 3.0).put("h", 0.4);
        ledge.put("x", 2.0).put("y", 2.0).put("material", "stone").put("dynamic", false);
    }
}
