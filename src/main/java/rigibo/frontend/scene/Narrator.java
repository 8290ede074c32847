package rigibo.frontend.scene;

/**
 * Takes in words what a window shows, for players who do not see it; see {@link Scene#describe}. A
 * page has one, a window on a desktop none.
 */
public interface Narrator {

    /** Something can be used at present. */
    void offers(Control control);

    /**
     * Says what has happened, or what the player should know now; a sentence is read once, when it
     * is new.
     */
    void says(String words);
}
