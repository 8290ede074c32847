package rigibo.frontend.scene;

/** What a click can do, besides deleting, as far as it sounds different. */
public enum Deed {
    /** A rope was cut. */
    SNIP,
    /** A pin was pulled. */
    PULL
}
