package rigibo.frontend.editor.pane;

import rigibo.backend.setup.Material;
import rigibo.frontend.editor.draft.Item;

/** The fields of what a body is made of, where it differs from its material, and of its motion. */
final class MatterPane {

    private static final double MOST_DENSITY = 100_000;
    private static final Fields.Range SPEED = new Fields.Range(-100, 100, 0.5, 0);

    private MatterPane() {}

    static void draw(Fields fields, Item item) {
        String at = item.pointer();
        Material usual = item.substance().material();
        fields.stated(
                "density", at + "/density", new Fields.Range(1, MOST_DENSITY, 50, usual.density()));
        fields.stated("friction", at + "/friction", new Fields.Range(0, 5, 0.05, usual.friction()));
        fields.stated(
                "bounce", at + "/restitution", new Fields.Range(0, 1, 0.05, usual.elasticity()));
        fields.stated(
                "rolling",
                at + "/rollingResistance",
                new Fields.Range(0, 1, 0.01, usual.rollingResistance()));
        fields.stated("drag", at + "/drag", new Fields.Range(0, 100, 0.1, usual.drag()));
        if (!item.isFixed()) {
            motion(fields, item);
        }
    }

    /** The motion with which a body or ball begins. */
    static void motion(Fields fields, Item item) {
        fields.stated("speed.x", item.pointer() + "/vx", SPEED);
        fields.stated("speed.y", item.pointer() + "/vy", SPEED);
        fields.stated("spin", item.pointer() + "/spin", SPEED);
    }
}
