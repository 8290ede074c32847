package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.desk.Leaf;
import rigibo.frontend.editor.draft.Box;
import rigibo.frontend.editor.draft.Corners;
import rigibo.frontend.editor.draft.Disc;
import rigibo.frontend.editor.draft.Form;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Landscape;
import rigibo.frontend.editor.draft.Pill;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.scene.Canvas;

/** The fields of the selected item. */
final class ItemPane {

    private static final Fields.Range PLACE = new Fields.Range(-1000, 1000, 0.05, 0);
    private static final Fields.Range ANGLE = new Fields.Range(-360, 360, 1, 0);
    private static final Fields.Range TILT = new Fields.Range(-45, 45, 1, 0);
    private static final Fields.Range SIZE = new Fields.Range(0.05, 20, 0.05, 0.05);
    private static final Fields.Range PLATFORM = new Fields.Range(0.2, 20, 0.05, 0.2);
    private static final Fields.Range THICKNESS = new Fields.Range(0.05, 2, 0.05, 0.3);
    private static final Fields.Range RADIUS = new Fields.Range(0.05, 5, 0.05, 0.05);
    private static final Fields.Range LENGTH = new Fields.Range(0, 20, 0.05, 0);
    private static final Fields.Range BALL = new Fields.Range(0.05, 2, 0.05, 0.05);

    private ItemPane() {}

    static void draw(Fields fields, Item item) {
        if (item.kind() == Item.Kind.BODY) {
            Leaf leaf = fields.desk().bodyLeaf();
            fields.leaves(Leaf.OF_BODY, leaf);
            switch (leaf) {
                case PLAY -> PlayPane.draw(fields, item);
                case MATTER -> MatterPane.draw(fields, item);
                default -> shape(fields, item);
            }
        } else {
            shape(fields, item);
        }
    }

    private static void shape(Fields fields, Item item) {
        String at = item.pointer();
        name(fields, item);
        fields.number("x", at + "/x", PLACE);
        fields.number("y", at + "/y", PLACE);
        switch (item.kind()) {
            case BALL -> {
                fields.number("radius", at + "/radius", BALL);
                material(fields, item);
                MatterPane.motion(fields, item);
            }
            case PLATFORM -> {
                fields.number("angle", at + "/angle", TILT);
                fields.number("width", at + "/w", PLATFORM);
                fields.number("height", at + "/h", THICKNESS);
            }
            case BODY -> body(fields, item);
        }
        if (item.isDispensable()) {
            Desk desk = fields.desk();
            button(fields, "remove", desk::remove);
        }
    }

    private static void name(Fields fields, Item item) {
        switch (item.kind()) {
            case BALL -> fields.column().heading(fields.words("ball"));
            case PLATFORM -> fields.column().heading(fields.words("platform"));
            case BODY ->
                    fields.text(
                            item.pointer() + "/id",
                            "name",
                            item.id(),
                            typed -> fields.desk().rename(item, typed.trim()));
        }
    }

    private static void body(Fields fields, Item item) {
        String at = item.pointer();
        fields.number("angle", at + "/angle", ANGLE);
        size(fields, item);
        material(fields, item);
        if (!item.node().has("path") && !item.form().isLandscape()) {
            fields.flag("moves", at + "/dynamic", !item.isFixed());
        }
        Desk desk = fields.desk();
        button(fields, "copy", desk::duplicate);
    }

    private static void size(Fields fields, Item item) {
        String shape = item.pointer() + "/shape";
        Form form = item.form();
        Desk desk = fields.desk();
        if (form instanceof Box box) {
            fields.number("width", shape + "/w", SIZE, resized(box, true, item));
            fields.number("height", shape + "/h", SIZE, resized(box, false, item));
            double most = Box.mostRound(box.width(), box.height());
            fields.stated("round", shape + "/round", new Fields.Range(0, most, 0.05, 0));
        } else if (form instanceof Disc) {
            fields.number("radius", shape + "/r", RADIUS);
        } else if (form instanceof Pill) {
            fields.number("length", shape + "/length", LENGTH);
            fields.number("radius", shape + "/r", RADIUS);
        } else if (form instanceof Corners polygon) {
            fields.column().note(fields.words("corners", polygon.corners().size()));
            if (polygon.isConcave()) {
                button(fields, "split", () -> desk.form(item, polygon.whole()));
            }
        } else if (form instanceof Landscape landscape) {
            fields.column().note(fields.words("points", landscape.corners().size()));
            button(fields, "over", () -> desk.put(item.formed(landscape.turnedOver())));
        } else {
            fields.column().note(fields.words("parts", item.node().at("/shape/parts").size()));
            button(fields, "apart", () -> desk.takeApart(item));
        }
    }

    private static Fields.Edit resized(Box box, boolean isWidth, Item item) {
        return (draft, value) ->
                draft.with(
                        item.formed(
                                isWidth
                                        ? box.sized(value, box.height())
                                        : box.sized(box.width(), value)));
    }

    private static void button(Fields fields, String key, Runnable action) {
        fields.column().button(fields.words(key), fields.words(key + ".told"), action);
    }

    private static void material(Fields fields, Item item) {
        Substance[] all = Substance.values();
        Substance substance = item.substance();
        fields.column()
                .stepper(
                        "",
                        new Column.Shown(
                                fields.words("material." + substance.title()),
                                Canvas.Font.WORDS,
                                false),
                        () -> {},
                        direction ->
                                fields.desk()
                                        .substance(
                                                all[
                                                        Math.floorMod(
                                                                substance.ordinal() + direction,
                                                                all.length)]));
    }
}
