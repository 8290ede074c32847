package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Narrator;

/**
 * An option at a place on the screen.
 *
 * @param x left edge, logical px
 * @param y upper edge
 * @param width px
 * @param height px
 * @param name its name, for players who do not see it
 * @param look draws it
 * @param action its action
 */
public record Tile(
        double x, double y, double width, double height, String name, Look look, Runnable action) {

    /** Draws a tile. */
    public interface Look {

        /** Draws a tile, {@code isChosen} under the pointer or by keys. */
        void draw(Canvas canvas, Tile tile, boolean isChosen);
    }

    /** An option at a place. */
    public static Tile at(Plate place, String name, Look look, Runnable action) {
        return new Tile(place.x(), place.y(), place.width(), place.height(), name, look, action);
    }

    /** A button with its name on it. */
    public static Tile button(Plate place, String name, Runnable action) {
        Look look = (canvas, tile, isChosen) -> Print.button(canvas, tile, name, isChosen);
        return at(place, name, look, action);
    }

    /** A button that leads back. */
    public static Tile wayBack(Plate place, String name, Runnable action) {
        String words = "‹  " + name;
        Look look = (canvas, tile, isChosen) -> Print.button(canvas, tile, words, isChosen);
        return at(place, name, look, action);
    }

    /** Tells of it, {@code isChosen} under the pointer or by keys. */
    public void describe(Narrator narrator, boolean isChosen) {
        narrator.offers(new Plate(x, y, width, height).button(name, isChosen));
    }

    /** The middle, px. */
    public double middleX() {
        return x + width / 2;
    }

    /** The middle, px. */
    public double middleY() {
        return y + height / 2;
    }

    /** Whether a point of the screen, px, lies on it. */
    public boolean contains(double px, double py) {
        return px >= x && px <= x + width && py >= y && py <= y + height;
    }

    /** Draws it, {@code isChosen} under the pointer or by keys. */
    public void draw(Canvas canvas, boolean isChosen) {
        look.draw(canvas, this, isChosen);
    }
}
