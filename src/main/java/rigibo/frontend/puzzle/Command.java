package rigibo.frontend.puzzle;

import rigibo.frontend.scene.Words;

import java.util.Locale;

/** The player's commands besides deleting a box. */
enum Command {
    PAUSE,
    RESUME,
    RESTART,
    UNDO,
    SLOWER,
    EFFECTS,
    HINT,
    /** Shows a stored solution. */
    SOLUTION,
    /** Shows the player's own solved try once more. */
    REPLAY,
    /** Ends what is being shown. */
    STOP,
    NEXT,
    LEVELS,
    MENU;

    /** What a button for it says. */
    String words(Words words) {
        return words.of("puzzle.command." + key(this));
    }

    /** The key that does the same, for those that have one. */
    String keyWords(Words words) {
        return words.of("puzzle.key." + key(this));
    }

    /** The last part of the key of a constant's words. */
    static String key(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
