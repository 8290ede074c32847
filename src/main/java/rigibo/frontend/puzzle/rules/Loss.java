package rigibo.frontend.puzzle.rules;

/** The reasons for a lost game. */
public enum Loss {
    /** The ball left the world after it had been on the platform. */
    ROLLED_OFF("rolled off"),
    /** The ball left the world without having touched the platform. */
    LEFT_THE_WORLD("left the world"),
    /** All is at rest, the ball is not on the platform, and no click can change that. */
    NOTHING_LEFT_TO_DELETE("nothing left to delete"),
    /** As above, in levels whose clicks do more than delete. */
    NOTHING_LEFT_TO_CLICK("nothing left to click"),
    /** The level's time limit has passed. */
    TIME_IS_UP("time is up");

    private final String words;

    Loss(String words) {
        this.words = words;
    }

    /** The reason in English, for messages about level files. */
    public String words() {
        return words;
    }
}
