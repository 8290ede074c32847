package rigibo.frontend.scene;

/** What a solved level earns; time never counts. */
public enum Medal {
    GOLD,
    SILVER,
    BRONZE;

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
