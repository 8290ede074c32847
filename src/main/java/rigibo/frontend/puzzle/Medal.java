package rigibo.frontend.puzzle;

/** What a solved level earns; time never counts. */
enum Medal {
    GOLD,
    SILVER,
    BRONZE;

    static Medal of(int clicks, int par) {
        if (clicks <= par) {
            return GOLD;
        }
        return clicks == par + 1 ? SILVER : BRONZE;
    }
}
