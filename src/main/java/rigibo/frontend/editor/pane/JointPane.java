package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Joinery;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.puzzle.level.LevelJoint;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

import java.util.Locale;

/** The fields of the selected joint. */
final class JointPane {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private static final Fields.Range PLACE = new Fields.Range(-1000, 1000, 0.05, 0);
    private static final Fields.Range SLIDE_AXIS = new Fields.Range(-360, 360, 5, 0);
    private static final Fields.Range WHEEL_AXIS = new Fields.Range(-360, 360, 5, 90);
    private static final Fields.Range DEGREES = new Fields.Range(-1000, 1000, 5, 0);
    private static final Fields.Range METRES = new Fields.Range(-1000, 1000, 0.05, 0);
    private static final Fields.Range SPEED = new Fields.Range(-100, 100, 0.5, 0);
    private static final Fields.Range MOST = new Fields.Range(0, 100_000, 10, 0);
    private static final Fields.Range HERTZ = new Fields.Range(0.01, 60, 0.25, 1);
    private static final Fields.Range DAMPING = new Fields.Range(0, 10, 0.1, 0);
    private static final Fields.Range BREAK = new Fields.Range(0, 100_000, 50, 0);

    private static final double SWING = 45;
    private static final double STRUT = 0.2;
    private static final double RAIL = 1;
    private static final double USUAL_MOST = 100;

    private final Fields fields;
    private final JointEntry joint;
    private final LevelJoint.Type type;

    private JointPane(Fields fields, JointEntry joint) {
        this.fields = fields;
        this.joint = joint;
        type = joint.type();
    }

    static void draw(Fields fields, JointEntry joint) {
        new JointPane(fields, joint).draw();
    }

    private void draw() {
        String name = type.name().toLowerCase(Locale.ROOT);
        Desk desk = fields.desk();
        name(name);
        fields.column()
                .button(
                        fields.words("joint.ends", joint.a(), joint.b()),
                        fields.words("joint.ends.told"),
                        () -> put(joint.swapped()));
        if (type.hasTwoPoints()) {
            place("from", "joint.from.");
            place("to", "joint.to.");
        } else {
            place("at", "");
        }
        axis();
        length();
        limits();
        motor();
        spring();
        click();
        fields.limit("joint.break", joint.pointer() + "/breakForce", BREAK);
        fields.column().button(fields.words("remove"), fields.words("remove.told"), desk::remove);
    }

    private void put(JointEntry changed) {
        fields.desk().change(fields.desk().draft().with(changed.pointer(), changed.node()));
    }

    private void place(String anchor, String key) {
        fields.number(key + "x", joint.pointer() + "/" + anchor + "/0", PLACE);
        fields.number(key + "y", joint.pointer() + "/" + anchor + "/1", PLACE);
    }

    private void axis() {
        if (type == LevelJoint.Type.WHEEL) {
            fields.number("joint.axis", joint.pointer() + "/axis", WHEEL_AXIS);
        } else if (type == LevelJoint.Type.SLIDE) {
            fields.number("joint.axis", joint.pointer() + "/axis", SLIDE_AXIS);
        }
    }

    /** As long as its ends are apart, unless the file says otherwise. */
    private void length() {
        if (type == LevelJoint.Type.ROPE || type == LevelJoint.Type.SPRING) {
            Fields.Range range = new Fields.Range(0.01, 100, 0.05, joint.span());
            fields.number("joint.length", joint.pointer() + "/length", range);
        }
    }

    private void limits() {
        boolean canHave =
                type != LevelJoint.Type.WELD
                        && type != LevelJoint.Type.ROD
                        && type != LevelJoint.Type.ROPE;
        if (canHave && isOn("limits", "limits", usualLimits())) {
            Fields.Range range = type == LevelJoint.Type.HINGE ? DEGREES : METRES;
            String unit = type == LevelJoint.Type.HINGE ? "degrees" : "metres";
            fields.number("joint.lower." + unit, joint.pointer() + "/limits/0", range);
            fields.number("joint.upper." + unit, joint.pointer() + "/limits/1", range);
        }
    }

    private JsonNode usualLimits() {
        double aside =
                switch (type) {
                    case HINGE -> SWING;
                    case WHEEL -> STRUT;
                    default -> RAIL;
                };
        return type.hasTwoPoints()
                ? NODES.arrayNode().add(0).add(rounded(2 * joint.span()))
                : NODES.arrayNode().add(-aside).add(aside);
    }

    private static double rounded(double metres) {
        return Decimal.rounded(metres);
    }

    private void motor() {
        boolean turns = type == LevelJoint.Type.HINGE || type == LevelJoint.Type.WHEEL;
        JsonNode usual = NODES.objectNode().put("speed", 1.0).put("most", USUAL_MOST);
        if ((turns || type == LevelJoint.Type.SLIDE) && isOn("motor", "motor", usual)) {
            String unit = turns ? "turning" : "sliding";
            fields.number("joint.speed." + unit, joint.pointer() + "/motor/speed", SPEED);
            fields.number("joint.most." + unit, joint.pointer() + "/motor/most", MOST);
        }
    }

    /** A spring is one; in others it is a choice. */
    private void spring() {
        boolean canHave = type != LevelJoint.Type.ROD && type != LevelJoint.Type.ROPE;
        boolean has =
                type == LevelJoint.Type.SPRING
                        || canHave && isOn("spring", "springy", Joinery.spring(HERTZ.usual(), 1));
        if (has) {
            fields.number("joint.hertz", joint.pointer() + "/spring/hertz", HERTZ);
            fields.number("joint.damping", joint.pointer() + "/spring/damping", DAMPING);
        }
    }

    /** A joint that can be clicked has a name, by which solutions refer to it. */
    private void name(String type) {
        if (joint.verb().isEmpty()) {
            fields.column().heading(fields.words("joint." + type));
        } else {
            fields.text(
                    joint.pointer() + "/id",
                    "joint." + type,
                    joint.id(),
                    typed -> fields.desk().rename(joint, typed.trim()));
        }
    }

    private void click() {
        if (!joint.fitting().isEmpty()) {
            ClickRow.draw(
                    fields,
                    joint.node(),
                    joint.fitting(),
                    next -> put(joint.clicked(fields.desk().draft(), next.verb(), next.isOn())));
        }
    }

    /** A switch that gives the joint a member or takes it away; returns whether it has it. */
    private boolean isOn(String member, String key, JsonNode usual) {
        boolean has = joint.node().has(member);
        String pointer = joint.pointer() + "/" + member;
        Desk desk = fields.desk();
        fields.column()
                .toggle(
                        fields.words("joint." + key),
                        has,
                        fields.words("joint." + key + ".told"),
                        () ->
                                desk.change(
                                        has
                                                ? desk.draft().without(pointer)
                                                : desk.draft().with(pointer, usual)));
        return has;
    }
}
