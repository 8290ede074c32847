package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Scene;

/** How much of the draft is seen. */
final class View {

    /** Around the draft when all of it is seen, px. */
    static final double MARGIN = 8;

    private final Desk desk;

    /** The part of the window that is left to the draft, and that with nothing else open. */
    private Area seen = DeskPlaces.DRAFT;

    private Area whole = DeskPlaces.DRAFT;

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
        return camera(draft, DeskPlaces.DRAFT);
    }

    /** A camera that shows all of a draft in a part of the window. */
    static Camera camera(Draft draft, Area part) {
        Camera camera = Camera.ofPuzzle();
        home(camera, draft, part);
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
