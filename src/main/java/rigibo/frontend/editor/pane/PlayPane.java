package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.puzzle.level.Verb;

import tools.jackson.databind.node.JsonNodeFactory;

import java.util.List;

/** The fields of what a body does in play. */
final class PlayPane {

    private static final Fields.Range REACH = new Fields.Range(0, 20, 0.1, 0);
    private static final Fields.Range IMPULSE = new Fields.Range(1, 100_000, 50, 1);
    private static final Fields.Range BELT = new Fields.Range(-20, 20, 0.1, 0);
    private static final Fields.Range SIDE = new Fields.Range(-360, 360, 15, 90);

    private PlayPane() {}

    static void draw(Fields fields, Item item) {
        String at = item.pointer();
        fields.flag("deletable", at + "/deletable", item.isDeletable());
        if (!item.isDeletable()) {
            click(fields, item);
        }
        if (!item.isSource()) {
            fields.stated("belt", at + "/surfaceSpeed", BELT);
        }
        oneWay(fields, item);
        PathPane.draw(fields, item);
        if (item.isFixed()) {
            SourcePane.draw(fields, item);
        }
    }

    /** Rows for the effect of a click other than deletion, and for the blast of a bomb. */
    private static void click(Fields fields, Item item) {
        List<Verb> fitting = item.fitting();
        if (!fitting.isEmpty()) {
            ClickRow.draw(
                    fields,
                    item.node(),
                    fitting,
                    next -> fields.desk().click(item, next.verb(), next.isOn()));
        }
        if (item.verb().filter(fitting::contains).filter(Verb.LIGHT::equals).isPresent()) {
            fields.number("blast.radius", item.pointer() + "/blast/radius", REACH);
            fields.number("blast.falloff", item.pointer() + "/blast/falloff", REACH);
            fields.number("blast.impulse", item.pointer() + "/blast/impulse", IMPULSE);
        }
    }

    private static void oneWay(Fields fields, Item item) {
        String pointer = item.pointer() + "/oneWay";
        boolean has = item.node().has("oneWay");
        fields.member("one-way", pointer, has, JsonNodeFactory.instance.numberNode(SIDE.usual()));
        if (has) {
            fields.number("one-way.side", pointer, SIDE);
        }
    }
}
