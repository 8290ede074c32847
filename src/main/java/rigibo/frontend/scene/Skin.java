package rigibo.frontend.scene;

/** The appearance of a body. */
public enum Skin {
    /** A box with a face. */
    RIGIBO(Color.RIGIBO),
    STONE(Color.STONE),
    /** Dark, with rivets. */
    IRON(Color.IRON),
    /** Pale, with cracks. */
    ICE(Color.ICE),
    /** Dotted. */
    RUBBER(Color.RUBBER),
    /** Grain along its length. */
    WOOD(Color.WOOD),
    /** Striped, so that its rotation shows. */
    BALL(Color.BALL),
    /** Chequered cloth: where a ball is to rest. */
    GOAL(Color.GOAL),
    /** A dark crust over what glows: a fire door. */
    EMBER(Color.EMBER);

    /** Its plain colour. */
    public final Color color;

    Skin(Color color) {
        this.color = color;
    }
}
