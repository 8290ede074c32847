package rigibo.frontend.scene;

/** The sounds of a scene. Silent without an audio device; no method ever waits. */
public interface Sounds {

    /**
     * Two bodies met.
     *
     * @param skin skin of the lighter body
     * @param size root of its area, m, more than 0: large bodies sound low
     * @param impulse N·s, more than 0: the larger, the louder
     */
    void knock(Skin skin, double size, double impulse);

    /** Something rolls at a speed, m/s; told each step while it does. */
    void roll(double speed);

    /** A box was deleted. */
    void pop();

    /** A click did something else. */
    void did(Deed deed);

    /** A refused click. */
    void refuse();

    /** A step of the hold's clock, 0 to 1 of the hold done: higher towards its end. */
    void tick(double held);

    /** The level is solved. */
    void chord();

    /** The level is lost. */
    void fail();

    /** A button was pressed in a menu. */
    void press();

    /** Whether anything is heard at all; what takes time to find out need not be told if not. */
    boolean isHeard();
}
