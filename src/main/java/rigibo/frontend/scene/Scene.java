package rigibo.frontend.scene;

import java.util.Optional;
import java.util.Set;

/**
 * The content of a window: a menu, a demo, a level. Coordinates are logical pixels, y down; in a
 * window of another shape than the scene's they go on beyond its edges, see {@link Layout}.
 */
public interface Scene {

    /** Width and height of a scene in logical pixels. */
    int WIDTH = 720;

    int HEIGHT = 800;

    /** Simulated time of a step, s. */
    double STEP = 1.0 / 60;

    /** The window's title. */
    String title();

    /** The link to it with its present choices; the menu's where no link leads here. */
    default Link link() {
        return Link.MENU;
    }

    /**
     * Chooses what a link says, once, before anything else; returns whether it could choose all.
     */
    default boolean follow(Link link) {
        return link.choices().isEmpty();
    }

    /** Its scenery. */
    default Scenery scenery() {
        return Scenery.WORKSHOP;
    }

    /** Whether it has plates that stand beside it where the window has room for them. */
    default boolean hasColumns() {
        return false;
    }

    /** Whether it has a text beside it that should get all the room there is. */
    default boolean hasSource() {
        return false;
    }

    /** Factor up to which its small text can grow; see {@link Layout#withText}. */
    default double mostType() {
        return Layout.MOST_TYPE;
    }

    /**
     * Whether it has a layout of its own for a handheld window; otherwise it is shrunk to fit
     * there.
     */
    default boolean isForHands() {
        return isSheet();
    }

    /**
     * Whether its layout for a hand is in px of a {@link Layout#sheet}: for scenes that are lists
     * and plates, and nothing but those.
     */
    default boolean isSheet() {
        return false;
    }

    /**
     * Goes on by one {@link #STEP}: once in a turn of the loop, more often when pictures are late.
     */
    void step();

    /** Draws everything. */
    void draw(Canvas canvas);

    /** Tells in words what was last drawn: all controls, and what has happened. */
    default void describe(Narrator narrator) {}

    /** A frame was drawn and took this long, ns, all that OpenGL had to do for it included. */
    default void drawn(long nanos) {}

    /** Called after every turn: the share of real time that the world runs at, 0 to 1. */
    default void paced(double share) {}

    /** The window is gone for good: whatever the scene has started ends. */
    default void closed() {}

    /** The pointer moved. */
    default void pointerMoved(double x, double y) {}

    /** A button went down. */
    default void pointerPressed(PointerButton button, double x, double y) {}

    /** A button went up. */
    default void pointerReleased(PointerButton button, double x, double y) {}

    /** When a finger at a point presses. */
    default Tap tap(double x, double y) {
        return Tap.AT_ONCE;
    }

    /** A finger begins or stops choosing what is under the pointer; see {@link Tap#CHOSEN}. */
    default void choosing(boolean isChoosing) {}

    /** Cancels what the pointer has begun and not finished; its button goes up next. */
    default void interrupted() {}

    /** Two fingers moved or enlarged the view. */
    default void pinched(Pinch pinch) {}

    /** The wheel turned; positive away from the user. */
    default void scrolled(double notches, double x, double y) {}

    /** The kind of scene whose keys the player may choose; none where keys are as they are. */
    default Optional<Action.Place> place() {
        return Optional.empty();
    }

    /**
     * A key went down or repeats. Where keys may be chosen, it is the default key of the action
     * that was meant.
     */
    default void keyPressed(Key key) {}

    /** The modifier keys that are held down; told before each other key or button. */
    default void held(Set<Modifier> modifiers) {}

    /** A character was typed, as the keyboard's layout has it: a code point of Unicode. */
    default void typed(int codePoint) {}

    /** Whether keys now type text; then no key but Esc means anything else. */
    default boolean isTyping() {
        return false;
    }

    /** A text was pasted; returns whether the scene had a use for it. */
    default boolean pasted(String text) {
        return false;
    }

    /** Esc was pressed; returns whether the scene had a use for it and is not to be left. */
    default boolean escaped() {
        return false;
    }

    /** How this scene plays itself, where it can. */
    default Optional<Demonstration> demonstration() {
        return Optional.empty();
    }
}
