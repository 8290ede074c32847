package rigibo.frontend.scene;

/** Presses what a scene draws, by the words on it. */
public final class Pointing {

    private Pointing() {}

    /** Moves the mouse to the words that were drawn last, and clicks. */
    public static void click(Scene scene, String words) {
        click(scene, Layout.ALONE, words);
    }

    /** Moves the mouse to the words that were drawn last in a window, and clicks. */
    public static void click(Scene scene, Layout layout, String words) {
        double[] at = RecordingCanvas.of(scene, layout).middleOf(words);
        scene.pointerMoved(at[0], at[1]);
        tap(scene, at);
    }

    /** Touches the words that were drawn first in a window. */
    public static void touch(Scene scene, Layout layout, String words) {
        tap(scene, RecordingCanvas.of(scene, layout).firstMiddleOf(words));
    }

    private static void tap(Scene scene, double[] at) {
        scene.pointerPressed(PointerButton.LEFT, at[0], at[1]);
        scene.pointerReleased(PointerButton.LEFT, at[0], at[1]);
    }
}
