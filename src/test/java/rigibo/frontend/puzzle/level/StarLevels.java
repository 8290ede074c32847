package rigibo.frontend.puzzle.level;

/** Levels with a secret star, based on the small valid one. */
public final class StarLevels {

    private static final String WALL = "\"material\": \"stone\", \"dynamic\": false";

    /** Clicks that earn the star by default. */
    private static final String BOX = "{\"t\": 1.0, \"body\": \"box\"}";

    private StarLevels() {}

    /**
     * The text of a level with a star: the ball stands on "box", and "wall" can be deleted, too.
     *
     * @param feat its type and parameters, with single quotes
     */
    public static String text(String feat) {
        return text(feat, BOX);
    }

    /** The text of such a level with given clicks that earn its star. */
    public static String text(String feat, String clicks) {
        String star =
                "\"star\": {"
                        + feat.replace('\'', '"')
                        + ", \"text\": {\"en\": \"Well done.\"}, \"solution\": {\"clicks\": ["
                        + clicks
                        + "]}},\n  ";
        return LevelTexts.with("\"format\": 1", "\"format\": 2")
                .replace(WALL, WALL + ", \"deletable\": true")
                .replace("\"solutions\"", star + "\"solutions\"");
    }

    /** Such a level, read. */
    public static Level level(String feat) {
        return LevelTexts.level(text(feat));
    }
}
