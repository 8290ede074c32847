package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.editor.pane.Spots;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;

import java.util.Locale;

/** Names of the things on the desk, for authors who do not see them. */
final class DeskNames {

    /** Round about the point at which something is pressed, px. */
    private static final double REACH = 22;

    private final Words words;
    private final Desk desk;

    DeskNames(Words words, Desk desk) {
        this.words = words;
        this.desk = desk;
    }

    /** Tells of all that no pane covers. */
    void describe(Narrator narrator, Spots spots) {
        for (Item item : desk.draft().items()) {
            offer(narrator, spots, name(item), item.pointer(), item.place());
        }
        for (JointEntry joint : JointEntry.all(desk.draft())) {
            Point at = joint.point(joint.anchors().get(0));
            offer(narrator, spots, name(joint), joint.pointer(), at);
        }
    }

    private void offer(Narrator narrator, Spots spots, String name, String pointer, Point at) {
        Camera camera = desk.camera();
        double x = camera.screenX(at.x());
        double y = camera.screenY(at.y());
        if (!spots.covers(x, y)) {
            Plate place = new Plate(x - REACH, y - REACH, 2 * REACH, 2 * REACH);
            Control.Kind kind = Control.Kind.of(pointer.equals(desk.chosen()));
            narrator.offers(place.control(name, kind, 0.5, false));
        }
    }

    private String name(Item item) {
        return switch (item.kind()) {
            case BALL -> words.of("editor.ball");
            case PLATFORM -> words.of("editor.platform");
            case BODY ->
                    words.of(
                            "editor.thing",
                            item.id(),
                            words.of("editor.material." + item.substance().title()));
        };
    }

    private String name(JointEntry joint) {
        String kind = joint.type().name().toLowerCase(Locale.ROOT);
        String ends = words.of("editor.joint.ends", joint.a(), joint.b());
        return words.of("editor.thing", words.of("editor.joint." + kind), ends);
    }
}
