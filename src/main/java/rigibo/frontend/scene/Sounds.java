package rigibo.frontend.scene;

/** What can be heard. */
public interface Sounds {

    /** Silence: for tests, and where there is no device. */
    Sounds SILENT = (sound, pitch, volume) -> {};

    /** Plays a sound, at a pitch of 1 as it was made, at a volume from 0 to 1. */
    void play(Sound sound, double pitch, double volume);

    /** The sounds there are. */
    enum Sound {
        KNOCK,
        POP,
        TICK,
        CHORD
    }
}
