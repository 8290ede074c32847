package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Corners;
import rigibo.frontend.editor.draft.Form;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Kept;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.scene.Canvas;

import java.util.List;

/** The fields of the selected item. */
final class ItemPane {

    private static final Fields.Range PLACE = new Fields.Range(-1000, 1000, 0.05, 0);
    private static final Fields.Range ANGLE = new Fields.Range(-360, 360, 1, 0);
    private static final Fields.Range TILT = new Fields.Range(-45, 45, 1, 0);
    private static final Fields.Range SIZE = new Fields.Range(0.05, 20, 0.05, 0.05);
    private static final Fields.Range PLATFORM = new Fields.Range(0.2, 20, 0.05, 0.2);
    private static final Fields.Range THICKNESS = new Fields.Range(0.05, 2, 0.05, 0.3);
    private static final Fields.Range RADIUS = new Fields.Range(0.05, 5, 0.05, 0.05);
    private static final Fields.Range BALL = new Fields.Range(0.05, 2, 0.05, 0.05);
    private static final Fields.Range REACH = new Fields.Range(0, 20, 0.1, 0);
    private static final Fields.Range IMPULSE = new Fields.Range(1, 100_000, 50, 1);
    private static final Fields.Range BELT = new Fields.Range(-20, 20, 0.1, 0);

    private ItemPane() {}

    static void draw(Fields fields, Item item) {
        String at = item.pointer();
        name(fields, item);
        fields.number("x", at + "/x", PLACE);
        fields.number("y", at + "/y", PLACE);
        switch (item.kind()) {
            case BALL -> fields.number("radius", at + "/radius", BALL);
            case PLATFORM -> {
                fields.number("angle", at + "/angle", TILT);
                fields.number("width", at + "/w", PLATFORM);
                fields.number("height", at + "/h", THICKNESS);
            }
            case BODY -> body(fields, item);
        }
        if (item.isDispensable()) {
            Desk desk = fields.desk();
            fields.column()
                    .button(fields.words("remove"), fields.words("remove.told"), desk::remove);
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
        fields.flag("moves", at + "/dynamic", !item.isFixed());
        fields.flag("deletable", at + "/deletable", item.isDeletable());
        if (!item.isSource()) {
            fields.number("belt", at + "/surfaceSpeed", BELT);
        }
        if (!item.isDeletable()) {
            click(fields, item);
        }
        if (item.isFixed()) {
            SourcePane.draw(fields, item);
        }
        Desk desk = fields.desk();
        fields.column().button(fields.words("copy"), fields.words("copy.told"), desk::duplicate);
    }

    /** What a click does besides deleting, and the blast of a bomb. */
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

    private static void size(Fields fields, Item item) {
        String shape = item.pointer() + "/shape";
        Form form = item.form();
        if (form instanceof Corners polygon) {
            fields.column().note(fields.words("corners", polygon.corners().size()));
        } else if (form instanceof Kept) {
            fields.column().note(fields.words("kept"));
        } else if (form.corners().isEmpty()) {
            fields.number("radius", shape + "/r", RADIUS);
        } else {
            fields.number("width", shape + "/w", SIZE);
            fields.number("height", shape + "/h", SIZE);
        }
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
