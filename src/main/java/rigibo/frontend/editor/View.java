package rigibo.frontend.editor;

import rigibo.frontend.editor.draft.Decimal;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Scene;

/** The layout of the window, and the initial view of the draft. */
final class View {

    static final Area TOP = new Area(4, 4, 712, 44);
    static final Area TOOLS = new Area(4, 54, 96, 602);
    static final Area FIELDS = new Area(486, 54, 230, 458);
    static final Area PROBLEMS = new Area(486, 518, 230, 138);
    static final Area FOOT = new Area(4, 662, 712, 134);

    /** The part of the window that the panes leave to the draft. */
    static final Area DRAFT = new Area(104, 54, 378, 602);

    private static final double MARGIN = 8;

    private View() {}

    static Camera camera(Draft draft) {
        Camera camera = Camera.ofPuzzle();
        home(camera, draft);
        return camera;
    }

    /** A camera that shows the whole world in the middle of that part. */
    static void home(Camera camera, Draft draft) {
        double width = Math.max(1, Decimal.read(draft.at("/world/width"), 1));
        double height = Math.max(1, Decimal.read(draft.at("/world/height"), 1));
        double scale =
                Math.min(
                        (DRAFT.width() - 2 * MARGIN) / width,
                        (DRAFT.height() - 2 * MARGIN) / height);
        double right = (Scene.WIDTH - DRAFT.width()) / 2 - DRAFT.x();
        double down = DRAFT.y() + DRAFT.height() / 2 - Scene.HEIGHT / 2.0;
        camera.look(width / 2 + right / scale, height / 2 + down / scale, scale);
    }
}
