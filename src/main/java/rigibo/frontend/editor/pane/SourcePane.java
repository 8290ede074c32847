package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.draft.Item;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

/** The fields of the fan or magnet that a fixed body is. */
final class SourcePane {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final Fields.Range ANGLE = new Fields.Range(-360, 360, 15, 90);
    private static final Fields.Range WIDTH = new Fields.Range(0.05, 20, 0.1, 1);
    private static final Fields.Range REACH = new Fields.Range(0.05, 50, 0.25, 1);
    private static final Fields.Range FORCE = new Fields.Range(-100_000, 100_000, 100, 0);
    private static final Fields.Range PULL = new Fields.Range(-1000, 1000, 1, 0);

    private SourcePane() {}

    static void draw(Fields fields, Item item) {
        String fan = item.pointer() + "/fan";
        String magnet = item.pointer() + "/magnet";
        JsonNode stream = NODES.objectNode().put("width", 1.0).put("reach", 4.0).put("force", 5000);
        JsonNode pull = NODES.objectNode().put("strength", 30.0).put("reach", 2.5);
        boolean isFan = item.node().has("fan");
        boolean isMagnet = item.node().has("magnet");
        if (!isMagnet) {
            fields.member("fan", fan, isFan, stream);
        }
        if (isFan) {
            fields.stated("fan.angle", fan + "/angle", ANGLE);
            fields.number("fan.width", fan + "/width", WIDTH);
            fields.number("fan.reach", fan + "/reach", REACH);
            fields.number("fan.force", fan + "/force", FORCE);
        } else {
            fields.member("magnet", magnet, isMagnet, pull);
        }
        if (isMagnet) {
            fields.number("magnet.strength", magnet + "/strength", PULL);
            fields.number("magnet.reach", magnet + "/reach", REACH);
        }
    }
}
