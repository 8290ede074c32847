package rigibo.frontend.puzzle.level;

/** Small levels, one for each verb besides deleting. */
public final class VerbLevels {

    private static final String HEAD =
            """
            {
              "format": 2,
              "id": "verb",
              "title": {"en": "Verb"},
              "world": {
                "width": 9, "height": 10, "gravity": [0, -9.81],
                "effects": ["gravity", "contacts", "rotation", "friction", "joints"]
              },
              "rules": {"cooldown": 1.0, "hold": 3.0, "par": 1},
            """;

    /**
     * The ball hangs on a rope from a box; both can be clicked. A shelf is left of the platform.
     */
    public static final String ROPE =
            HEAD
                    + """
                      "ball": {"x": 2, "y": 5, "radius": 0.35},
                      "platform": {"x": 2, "y": 1.2, "w": 3},
                      "bodies": [
                        {"id": "hook", "shape": {"type": "box", "w": 0.6, "h": 0.6}, "x": 2, "y": 8.3,
                         "material": "rigibo", "dynamic": false, "deletable": true},
                        {"id": "floor", "shape": {"type": "box", "w": 9, "h": 0.4}, "x": 4.5, "y": 0.2,
                         "material": "stone", "dynamic": false}
                      ],
                      "joints": [
                        {"type": "rope", "id": "line", "click": "cut", "a": "hook", "b": "ball",
                         "from": [2, 8], "to": [2, 5], "length": 3}
                      ]
                    }
                    """;

    /** A bar that two pins hold level, of which one can be pulled. */
    public static final String PIN =
            HEAD
                    + """
                      "ball": {"x": 2, "y": 1.7, "radius": 0.35},
                      "platform": {"x": 2, "y": 1.2, "w": 3},
                      "bodies": [
                        {"id": "wall", "shape": {"type": "box", "w": 0.3, "h": 0.3}, "x": 6, "y": 7,
                         "material": "stone", "dynamic": false},
                        {"id": "bar", "shape": {"type": "box", "w": 2.4, "h": 0.2}, "x": 6, "y": 5,
                         "material": "rigibo"}
                      ],
                      "joints": [
                        {"type": "hinge", "a": "wall", "b": "bar", "at": [5, 5]},
                        {"type": "hinge", "id": "pin", "click": "pull", "a": "wall", "b": "bar",
                         "at": [7, 5]}
                      ]
                    }
                    """;

    private VerbLevels() {}

    /** A level of a text, read. */
    public static Level of(String text) {
        return LevelTexts.level(text);
    }

    /** The ball on a rope. */
    public static Level rope() {
        return of(ROPE);
    }

    /** A rope of 4.5 m between two points 4 m apart. */
    public static Level slackRope() {
        return of(
                ROPE.replace(
                                "\"from\": [2, 8], \"to\": [2, 5], \"length\": 3",
                                "\"from\": [3, 8], \"to\": [7, 8], \"length\": 4.5")
                        .replace("\"b\": \"ball\"", "\"b\": \"ceiling\"")
                        .replace(
                                "\"bodies\": [",
                                "\"bodies\": [{\"id\": \"ceiling\", \"shape\": {\"type\": \"box\","
                                        + " \"w\": 0.6, \"h\": 0.6}, \"x\": 7, \"y\": 0.75,"
                                        + " \"material\": \"rigibo\"},"));
    }

    /** The bar on two pins. */
    public static Level pin() {
        return of(PIN);
    }
}
