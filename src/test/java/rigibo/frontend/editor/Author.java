package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Leaf;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Modifier;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/** Someone who uses the editor as a player does: by what the window shows, pointer and keys. */
final class Author {

    static final int SELECT = 0;
    static final int BOX = 1;
    static final int DISC = 2;
    static final int CORNERS = 3;
    static final int REGULAR = 4;
    static final int BALL = 5;
    static final int CAPSULE = 6;
    static final int LANDSCAPE = 7;
    static final int GLUE = 8;

    final RecordingDirector director;
    final EditorScene scene;
    private final Camera camera;

    /** With a draft on the desk, and a folder to save to. */
    Author(DraftFile draft, Optional<Path> folder, String language) {
        director = new RecordingDirector(language);
        director.levels = folder.map(own -> own.resolve("levels"));
        scene = new EditorScene(director, draft);
        camera = View.camera(draft.draft());
    }

    static Author withNewLevel(Path folder) {
        return new Author(
                new DraftFile(NewLevel.draft(), Optional.empty()), Optional.of(folder), "en");
    }

    static Author with(Draft draft) {
        return new Author(new DraftFile(draft, Optional.empty()), Optional.empty(), "en");
    }

    RecordingCanvas look() {
        scene.step();
        return RecordingCanvas.of(scene);
    }

    void take(int tool) {
        look();
        click(DeskPlaces.TOOLS.x() + 26, DeskPlaces.TOOLS.y() + 26 + 44 * tool);
    }

    /** Takes up the tool for joints of a kind. */
    void take(LevelJoint.Type type) {
        look();
        click(DeskPlaces.TOOLS.x() + 70, DeskPlaces.TOOLS.y() + 26 + 44 * type.ordinal());
    }

    /** Turns the fields to a leaf, if what is chosen has it. */
    void turnTo(Leaf leaf) {
        String name = director.words().of("editor." + leaf.key());
        if (look().texts().contains(name)) {
            press(name);
        }
    }

    /** Presses the button with a name. */
    void press(String name) {
        double[] at = look().middleOf(name);
        click(at[0], at[1]);
    }

    void click(double x, double y) {
        scene.pointerMoved(x, y);
        scene.pointerPressed(PointerButton.LEFT, x, y);
        scene.pointerReleased(PointerButton.LEFT, x, y);
        look();
    }

    /** Clicks a point of the world, m. */
    void clickWorld(double x, double y) {
        look();
        click(camera.screenX(x), camera.screenY(y));
    }

    void drag(double fromX, double fromY, double toX, double toY) {
        look();
        scene.pointerPressed(PointerButton.LEFT, camera.screenX(fromX), camera.screenY(fromY));
        scene.pointerMoved(camera.screenX((fromX + toX) / 2), camera.screenY((fromY + toY) / 2));
        scene.pointerMoved(camera.screenX(toX), camera.screenY(toY));
        scene.pointerReleased(PointerButton.LEFT, camera.screenX(toX), camera.screenY(toY));
    }

    /** Drags the handle above a thing round its middle, a degree at each move. */
    void turnHandle(double x, double y, double stalk, int degrees) {
        look();
        scene.pointerPressed(PointerButton.LEFT, camera.screenX(x), camera.screenY(y + stalk));
        for (int i = 1; i <= degrees; i++) {
            double angle = Math.toRadians(i);
            scene.pointerMoved(
                    camera.screenX(x - stalk * Math.sin(angle)),
                    camera.screenY(y + stalk * Math.cos(angle)));
        }
        scene.pointerReleased(PointerButton.LEFT, camera.screenX(x), camera.screenY(y + stalk));
    }

    void type(String text) {
        text.codePoints().forEach(scene::typed);
        scene.keyPressed(Key.ENTER);
    }

    void control(Key key) {
        with(key, Modifier.CONTROL);
    }

    void with(Key key, Modifier modifier) {
        scene.held(EnumSet.of(modifier));
        scene.keyPressed(key);
        scene.held(Set.of());
    }

    Draft draft() {
        return scene.draft();
    }

    double number(String pointer) {
        return draft().at(pointer).asDouble(Double.NaN);
    }
}
