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

    /** A bar held level by two pins, one of which can be pulled. */
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

    /**
     * A wheel on a motor of 4 rad/s, a belt of 2 m/s with a crate on it, a box that freezes, and a
     * bomb beside a crate; the ball lies on the floor beside the platform.
     */
    public static final String MACHINES =
            HEAD.replace("\"joints\"]", "\"joints\", \"surface-speed\"]")
                    + """
                      "ball": {"x": 0.6, "y": 0.75, "radius": 0.35},
                      "platform": {"x": 2, "y": 1.2, "w": 1},
                      "bodies": [
                        {"id": "floor", "shape": {"type": "box", "w": 9, "h": 0.4}, "x": 4.5, "y": 0.2,
                         "material": "stone", "dynamic": false},
                        {"id": "wheel", "shape": {"type": "circle", "r": 0.5}, "x": 2, "y": 7,
                         "material": "plank"},
                        {"id": "belt", "shape": {"type": "box", "w": 4, "h": 0.3}, "x": 6, "y": 6,
                         "material": "rubber", "dynamic": false, "surfaceSpeed": -2, "click": "switch",
                         "on": false},
                        {"id": "crate", "shape": {"type": "box", "w": 0.5, "h": 0.5}, "x": 4.6, "y": 6.4,
                         "material": "plank", "restitution": 0},
                        {"id": "faller", "shape": {"type": "box", "w": 0.5, "h": 0.5}, "x": 8.5, "y": 9,
                         "material": "ice", "click": "freeze"},
                        {"id": "bomb", "shape": {"type": "circle", "r": 0.3}, "x": 4, "y": 0.7,
                         "material": "iron", "click": "light",
                         "blast": {"radius": 2, "falloff": 0, "impulse": 500}},
                        {"id": "mark", "shape": {"type": "box", "w": 0.5, "h": 0.5}, "x": 5.5, "y": 0.65,
                         "material": "plank"}
                      ],
                      "joints": [
                        {"type": "hinge", "id": "motor", "click": "switch", "on": false, "a": "floor",
                         "b": "wheel", "at": [2, 7], "motor": {"speed": 4, "most": 1000}}
                      ]
                    }
                    """;

    /** A fan that blows upwards under a plank of 90 kg, and a magnet over iron and wood. */
    public static final String SOURCES =
            HEAD.replace("\"joints\"]", "\"fan\", \"magnet\"]")
                    + """
                      "ball": {"x": 0.6, "y": 0.75, "radius": 0.35},
                      "platform": {"x": 8, "y": 1.2, "w": 1},
                      "bodies": [
                        {"id": "floor", "shape": {"type": "box", "w": 9, "h": 0.4}, "x": 4.5, "y": 0.2,
                         "material": "stone", "dynamic": false},
                        {"id": "fan", "shape": {"type": "box", "w": 1, "h": 0.3}, "x": 2, "y": 0.55,
                         "material": "iron", "dynamic": false, "click": "switch", "on": false,
                         "fan": {"width": 2, "reach": 6, "force": 2000}},
                        {"id": "plank", "shape": {"type": "box", "w": 0.5, "h": 0.3}, "x": 2, "y": 0.85,
                         "material": "plank"},
                        {"id": "magnet", "shape": {"type": "box", "w": 3, "h": 0.4}, "x": 5, "y": 6,
                         "material": "stone", "dynamic": false, "click": "switch", "on": false,
                         "magnet": {"strength": 40, "reach": 8}},
                        {"id": "iron", "shape": {"type": "box", "w": 0.4, "h": 0.4}, "x": 5, "y": 0.6,
                         "material": "iron"},
                        {"id": "wood", "shape": {"type": "box", "w": 0.4, "h": 0.4}, "x": 6, "y": 0.6,
                         "material": "plank"}
                      ]
                    }
                    """;

    /**
     * Four bombs in a row, without gravity, with weak blasts of 2 m: all but the last are within
     * reach of the one before.
     */
    public static final String BOMBS =
            HEAD.replace("-9.81", "0")
                    + """
                      "ball": {"x": 0.6, "y": 8.75, "radius": 0.35},
                      "platform": {"x": 2, "y": 8.2, "w": 3},
                      "bodies": [
                    """
                    + bomb("first", 1)
                    + ","
                    + bomb("near", 3.29)
                    + ","
                    + bomb("next", 5.58)
                    + ","
                    + bomb("far", 7.89)
                    + "]}";

    /**
     * The ball falls from 2 m onto a plate of ember that lies on a floor and can be frozen; beside
     * it a crate lies on another one.
     */
    public static final String EMBERS =
            HEAD.replace("\"joints\"", "\"continuous-impacts\"")
                    + """
                      "ball": {"x": 2, "y": 2.95, "radius": 0.35},
                      "platform": {"x": 6, "y": 1.2, "w": 1},
                      "bodies": [
                        {"id": "floor", "shape": {"type": "box", "w": 9, "h": 0.4}, "x": 4.5, "y": 0.2,
                         "material": "stone", "dynamic": false},
                        {"id": "plate", "shape": {"type": "box", "w": 1, "h": 0.2}, "x": 2, "y": 0.5,
                         "material": "ember", "click": "freeze"},
                        {"id": "other", "shape": {"type": "box", "w": 1, "h": 0.2}, "x": 4, "y": 0.5,
                         "material": "ember", "dynamic": false},
                        {"id": "crate", "shape": {"type": "box", "w": 0.5, "h": 0.5}, "x": 4, "y": 0.85,
                         "material": "plank"}
                      ]
                    }
                    """;

    private VerbLevels() {}

    private static String bomb(String id, double x) {
        return """
        {"id": "%s", "shape": {"type": "circle", "r": 0.3}, "x": %s, "y": 1,
         "material": "iron", "click": "light",
         "blast": {"radius": 1.5, "falloff": 0.5, "impulse": 0.001}}
        """
                .formatted(id, x);
    }

    /** A fan and a magnet. */
    public static Level sources() {
        return of(SOURCES);
    }

    /** Machines, a box that freezes, and a bomb. */
    public static Level machines() {
        return of(MACHINES);
    }

    /** The level of a text. */
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
