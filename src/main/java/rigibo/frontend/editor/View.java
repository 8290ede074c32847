package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Scene;

/** The layout of the desk, and how much of the draft is seen. */
final class View {

    static final Area TOP = new Area(4, 4, 712, 44);
    static final Area TOOLS = new Area(4, 54, 96, 602);
    static final Area FIELDS = new Area(486, 54, 230, 458);
    static final Area PROBLEMS = new Area(486, 518, 230, 138);
    static final Area FOOT = new Area(4, 662, 712, 134);

    /** The part of the window that the panes leave to the draft. */
    static final Area DRAFT = new Area(104, 54, 378, 602);

    private static final double MARGIN = 8;

    private final Desk desk;

    /** The part of the window that is left to the draft, and that with nothing else open. */
    private Area seen = DRAFT;

    private Area whole = DRAFT;

    /** The view of a desk. */
    View(Desk desk) {
        this.desk = desk;
    }

    /** The part of the window that is left to the draft. */
    Area seen() {
        return seen;
    }

    /** Shows all of the draft. */
    void home() {
        seen = whole;
        home(desk.camera(), desk.draft(), whole);
    }

    /**
     * Gives the draft another part of the window. The middle of the view stays the middle; if the
     * part has another shape, the whole draft is shown.
     *
     * @param most the part when nothing lies over it
     */
    void see(Area part, Area most) {
        if (!most.equals(whole)) {
            whole = most;
            home();
        }
        desk.camera().pan(part.middleX() - seen.middleX(), part.middleY() - seen.middleY());
        seen = part;
    }

    static Camera camera(Draft draft) {
        Camera camera = Camera.ofPuzzle();
        home(camera, draft, DRAFT);
        return camera;
    }

    /** Shows the whole world in the middle of a part of the window. */
    private static void home(Camera camera, Draft draft, Area part) {
        double width = Math.max(1, Decimal.read(draft.at("/world/width"), 1));
        double height = Math.max(1, Decimal.read(draft.at("/world/height"), 1));
        double scale =
                Math.min(
                        (part.width() - 2 * MARGIN) / width, (part.height() - 2 * MARGIN) / height);
        double right = Scene.WIDTH / 2.0 - part.middleX();
        double down = part.middleY() - Scene.HEIGHT / 2.0;
        camera.look(width / 2 + right / scale, height / 2 + down / scale, scale);
    }
}
