package rigibo.frontend.scene;

/**
 * Something that a pointer can use in a window, in words.
 *
 * @param name its name, with its value if it has one
 * @param kind what using it does
 * @param x left edge, logical px
 * @param y upper edge
 * @param width px
 * @param height px
 * @param share where a pointer should press it, as a share of the width; for a slider also its
 *     value
 * @param isChosen whether keys or the pointer have selected it
 */
public record Control(
        String name,
        Kind kind,
        double x,
        double y,
        double width,
        double height,
        double share,
        boolean isChosen) {

    /** The effect of using a control. */
    public enum Kind {
        BUTTON,
        /** A button whose thing is on, and goes off. */
        ON,
        /** A button whose thing is off, and goes on. */
        OFF,
        /** Sets a number to the share of the width at which it is used. */
        SLIDER;

        /** The kind of a button for something that is on or off. */
        public static Kind of(boolean isOn) {
            return isOn ? ON : OFF;
        }
    }
}
