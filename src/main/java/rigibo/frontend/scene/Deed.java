package rigibo.frontend.scene;

/** What a click can do besides deleting, told apart by its sound. */
public enum Deed {
    /** A rope was cut. */
    SNIP,
    /** A pin was pulled. */
    PULL,
    /** A motor or belt was switched on. */
    SWITCH_ON,
    /** A motor or belt was switched off. */
    SWITCH_OFF,
    /** A body became a stone. */
    FREEZE,
    /** A fuse was lit. */
    FUSE,
    /** A bomb blew up. */
    BLAST,
    /** A fire door begins to melt. */
    MELT
}
