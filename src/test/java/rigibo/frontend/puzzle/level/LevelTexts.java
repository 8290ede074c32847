package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Problem;

import java.util.List;

/** A small valid level, in which tests break one line at a time. */
public final class LevelTexts {

    /** Line numbers in the tests count in this text; the box stands on the platform. */
    public static final String SOUND =
            """
            {
              "format": 1,
              "id": "drop",
              "title": {"en": "Drop", "de": "Fall"},
              "world": {
                "width": 9, "height": 10, "gravity": [0, -9.81],
                "effects": ["gravity", "contacts", "rotation", "friction", "restitution"]
              },
              "rules": {"cooldown": 1.0, "hold": 3.0, "par": 1},
              "ball": {"x": 4.5, "y": 2.7, "radius": 0.35},
              "platform": {"x": 4.5, "y": 1.2, "w": 3.6},
              "bodies": [
                {"id": "box", "shape": {"type": "box", "w": 2, "h": 1}, "x": 4.5, "y": 1.85,
                 "material": "rigibo", "deletable": true},
                {"id": "wall", "shape": {"type": "box", "w": 0.5, "h": 4}, "x": 8, "y": 2,
                 "material": "stone", "dynamic": false}
              ],
              "solutions": [
                {"clicks": [{"t": 1.0, "body": "box"}]}
              ]
            }
            """;

    private LevelTexts() {}

    /** The problems of a level's text, a line each. */
    static List<String> problems(String text) {
        return new LevelLoader()
                .parse("a.json", text).problems().stream().map(Problem::toString).toList();
    }

    /** The valid level with a part of its text replaced. */
    public static String with(String part, String replacement) {
        if (!SOUND.contains(part)) {
            throw new IllegalArgumentException("the sound level has no " + part);
        }
        return SOUND.replace(part, replacement);
    }

    /** The valid level, read. */
    public static Level sound() {
        return level(SOUND);
    }

    /** Reads a level from its text, which must be valid. */
    public static Level level(String text) {
        LoadedLevel loaded = new LevelLoader().parse("level.json", text);
        return loaded.level()
                .orElseThrow(() -> new IllegalArgumentException("" + loaded.problems()));
    }
}
