package rigibo.frontend.scene;

import java.util.Set;
import java.util.function.Consumer;

/**
 * A player's settings, for all scenes.
 *
 * @param language of the words, one of {@link #LANGUAGES}
 * @param volume of the sounds, 0 to 1
 * @param isMuted whether there is no sound, whatever the volume
 * @param motion how much the picture shakes, flashes and fades
 * @param detail how much detail is drawn
 * @param isFullScreen whether windows fill the screen
 * @param hasGhost whether the best run of a level is shown beside the game
 * @param music volume of the music beside all other sounds, 0 to 1; 0 for none
 * @param text how large small text is
 * @param keys what keys do in levels, replays and demos
 */
public record Settings(
        String language,
        double volume,
        boolean isMuted,
        Motion motion,
        Detail detail,
        boolean isFullScreen,
        boolean hasGhost,
        double music,
        TextSize text,
        KeyBindings keys) {

    /** The languages there are words in, as ISO 639 names them. */
    public static final Set<String> LANGUAGES = Set.of("en", "de");

    /** How much moves that is no physics. */
    public enum Motion {
        FULL,
        /** Nothing shakes, flashes or fades. */
        REDUCED
    }

    /** How much is drawn. */
    public enum Detail {
        /** By how fast the machine draws. */
        AUTOMATIC,
        FULL,
        /** No shadows, no grain, no background but its colour. */
        LITE
    }

    /** How large small text is. */
    public enum TextSize {
        USUAL(1),
        LARGE(1.15),
        LARGEST(1.3);

        private final double share;

        TextSize(double share) {
            this.share = share;
        }

        /** As a share of the usual size. */
        public double share() {
            return share;
        }
    }

    public Settings {
        if (!LANGUAGES.contains(language)) {
            throw new IllegalArgumentException(
                    "Settings.language must be one of " + LANGUAGES + ", was " + language);
        }
        if (!(volume >= 0 && volume <= 1)) {
            throw new IllegalArgumentException("Settings.volume must be 0 to 1, was " + volume);
        }
        if (!(music >= 0 && music <= 1)) {
            throw new IllegalArgumentException("Settings.music must be 0 to 1, was " + music);
        }
    }

    /** The default settings, in the system's language if the game has it. */
    public static Settings initial(String systemLanguage) {
        String language = LANGUAGES.contains(systemLanguage) ? systemLanguage : "en";
        return new Settings(
                language,
                0.7,
                false,
                Motion.FULL,
                Detail.AUTOMATIC,
                false,
                false,
                0.5,
                TextSize.USUAL,
                KeyBindings.FIRST);
    }

    /** Returns these settings with another language. */
    public Settings withLanguage(String other) {
        return with(copy -> copy.language = other);
    }

    /** Returns these settings with another volume, 0 to 1. */
    public Settings withVolume(double other) {
        return with(copy -> copy.volume = other);
    }

    /** Returns these settings with sound or without. */
    public Settings withMuted(boolean other) {
        return with(copy -> copy.isMuted = other);
    }

    /** Returns these settings with another amount of motion. */
    public Settings withMotion(Motion other) {
        return with(copy -> copy.motion = other);
    }

    /** Returns these settings with another amount of detail. */
    public Settings withDetail(Detail other) {
        return with(copy -> copy.detail = other);
    }

    /** Returns these settings for windows or the full screen. */
    public Settings withFullScreen(boolean other) {
        return with(copy -> copy.isFullScreen = other);
    }

    /** Returns these settings with the ghost of the best run or without. */
    public Settings withGhost(boolean other) {
        return with(copy -> copy.hasGhost = other);
    }

    /** Returns these settings with another volume of the music, 0 to 1. */
    public Settings withMusic(double other) {
        return with(copy -> copy.music = other);
    }

    /** Returns these settings with other keys. */
    public Settings withKeys(KeyBindings other) {
        return with(copy -> copy.keys = other);
    }

    /** Returns these settings with another size of text. */
    public Settings withText(TextSize other) {
        return with(copy -> copy.text = other);
    }

    private Settings with(Consumer<Copy> change) {
        Copy copy = new Copy(this);
        change.accept(copy);
        return copy.settings();
    }

    /** Settings that can be changed, so that their list of components is written once. */
    private static final class Copy {

        private String language;
        private double volume;
        private boolean isMuted;
        private Motion motion;
        private Detail detail;
        private boolean isFullScreen;
        private boolean hasGhost;
        private double music;
        private TextSize text;
        private KeyBindings keys;

        private Copy(Settings from) {
            language = from.language;
            volume = from.volume;
            isMuted = from.isMuted;
            motion = from.motion;
            detail = from.detail;
            isFullScreen = from.isFullScreen;
            hasGhost = from.hasGhost;
            music = from.music;
            text = from.text;
            keys = from.keys;
        }

        private Settings settings() {
            return new Settings(
                    language,
                    volume,
                    isMuted,
                    motion,
                    detail,
                    isFullScreen,
                    hasGhost,
                    music,
                    text,
                    keys);
        }
    }
}
