package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.desk.Typing;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.JointEntry;

import java.util.Optional;

/** The fields on the right: those of the selection, or of the level if nothing is selected. */
public final class FieldPane {

    private FieldPane() {}

    /** Draws the page of it that is open. */
    public static void draw(Pane pane, Area area, Desk desk, Typing typing, Pages pages) {
        pane.plate(area);
        Column column = new Column(pane, area.inset(10), pages);
        Fields fields = new Fields(column, pane, desk, typing);
        pages.about(desk.chosen() + desk.bodyLeaf() + desk.levelLeaf());
        Optional<Item> item = desk.item();
        Optional<JointEntry> joint = desk.joint();
        if (item.isPresent()) {
            ItemPane.draw(fields, item.get());
        } else if (joint.isPresent()) {
            JointPane.draw(fields, joint.get());
        } else {
            LevelPane.draw(fields);
        }
        column.foot();
    }
}
