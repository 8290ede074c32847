package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

/** A button that leads back to the whole picture, for fingers that have enlarged a part of it. */
public final class WholePlate {

    private static final double SIZE = 17;
    private static final double HEIGHT = 36;
    private static final double PADDING = 14;

    /** From the edges of the scene, px. */
    private static final double GAP = 8;

    private final Words words;
    private Plate place = Plate.NONE;

    /** A button with its name in a language. */
    public WholePlate(Words words) {
        this.words = words;
    }

    /** Draws it in the right corner of the scene, above a height of the screen, px. */
    public void draw(Canvas canvas, double bottom) {
        double height = canvas.layout().clickable(HEIGHT);
        double width = canvas.textWidth(name(), SIZE, Canvas.Font.WORDS) + 2 * PADDING;
        double x = Scene.WIDTH - GAP - width;
        place = new Plate(x, bottom - GAP - height, width, height);
        canvas.panel(x, place.y(), width, height, 10, Color.PANEL_LIT);
        Print.centred(canvas, name(), x + width / 2, place.y() + height / 2, SIZE, Color.TEXT);
    }

    private String name() {
        return words.of("hand.whole");
    }

    /** It is not there. */
    public void hide() {
        place = Plate.NONE;
    }

    /** Whether a point lies on it, as it was last drawn. */
    public boolean contains(double x, double y) {
        return place.contains(x, y);
    }

    /** Tells of it, if it is there. */
    public void describe(Narrator narrator) {
        if (place != Plate.NONE) {
            narrator.offers(place.button(name(), false));
        }
    }
}
