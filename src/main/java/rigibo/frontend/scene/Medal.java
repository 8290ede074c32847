package rigibo.frontend.scene;

/** The medals for a solved level; time never counts. */
public enum Medal {
    GOLD(Color.of(0xFFD24A)),
    SILVER(Color.of(0xD5DAE3)),
    BRONZE(Color.of(0xCD8E5C));

    private final Color color;

    Medal(Color color) {
        this.color = color;
    }

    /** The colour of its metal. */
    public Color color() {
        return color;
    }

    /**
     * For a number of clicks.
     *
     * @param par clicks of a gold medal
     */
    public static Medal of(int clicks, int par) {
        if (clicks <= par) {
            return GOLD;
        }
        return clicks == par + 1 ? SILVER : BRONZE;
    }
}
