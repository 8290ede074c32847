package rigibo.frontend.puzzle.hud;

import rigibo.frontend.scene.Words;

import java.util.Locale;

/** The player's commands besides deleting a box. */
public enum Command {
    PAUSE,
    RESUME,
    RESTART,
    UNDO,
    SLOWER,
    EFFECTS,
    /** Shows the player's best run as a ghost beside the game. */
    GHOST,
    HINT,
    /** Shows a stored solution. */
    SOLUTION,
    /** Shows the player's own winning try again. */
    REPLAY,
    /** Puts the winning try on the clipboard, as a code. */
    COPY,
    /** Shows the whole picture again. */
    WHOLE,
    /** Ends a show. */
    STOP,
    NEXT,
    /** Goes on with endless levels, after the last of the game's. */
    ENDLESS,
    LEVELS,
    MENU,
    /** Ends the trial of a draft. */
    EDITOR;

    /** The label of its button. */
    String words(Words words) {
        return words.of("puzzle.command." + key(this));
    }

    /** The label of its button in windows without keys. */
    String shortWords(Words words) {
        return switch (this) {
            case SLOWER, COPY, SOLUTION, REPLAY -> words.of("puzzle.short." + key(this));
            default -> words(words);
        };
    }

    /** Its key, if it has one. */
    String keyWords(Words words) {
        return words.of("puzzle.key." + key(this));
    }

    /** The last part of the key of its words. */
    static String key(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
