package rigibo.frontend.sound;

import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.util.Comparator;
import java.util.PriorityQueue;

/**
 * Decides in each turn which sounds a device plays, so that nothing clips and no sound is drowned.
 */
final class Ensemble {

    /** Knocks that start in one turn; more are one noise to the ear. */
    private static final int KNOCKS_PER_TURN = 4;

    private static final int KNOCKING_VOICES = 12;
    private static final int SIGNALLING_VOICES = 4;

    /** The number of voices that a device needs. */
    static final int VOICES = KNOCKING_VOICES + SIGNALLING_VOICES + Music.VOICES;

    /**
     * Shares of full scale for knocks and for signals, kept apart so that a signal is heard in any
     * noise. With the shares of rolling and of the music they add up to 1.
     */
    private static final double MOST_KNOCKING = 0.38;

    private static final double MOST_SIGNALLING = 1 - MOST_KNOCKING - Rolling.MOST - Music.MOST;

    private final Device device;
    private final Samples samples;
    private final Voices knocking = new Voices(KNOCKING_VOICES, MOST_KNOCKING);
    private final Voices signalling = new Voices(SIGNALLING_VOICES, MOST_SIGNALLING);
    private final Rolling rolling = new Rolling();
    private final Music music;
    private final PriorityQueue<Knock> loudest =
            new PriorityQueue<>(Comparator.comparingDouble(Knock::gain));

    /** Plays the samples that the device holds, and a score if one is given. */
    Ensemble(Device device, Samples samples, Score score) {
        this.device = device;
        this.samples = samples;
        music = new Music(score, samples);
    }

    /** A knock, to be played with the turn unless that has louder ones. */
    void knock(Skin skin, double size, double impulse) {
        loudest.add(Knock.of(skin, size, impulse));
        if (loudest.size() > KNOCKS_PER_TURN) {
            loudest.remove();
        }
    }

    /** Something rolls at a speed, m/s. */
    void roll(double speed) {
        rolling.tell(speed);
    }

    /** Plays a signal at once, at a multiple of its pitch. */
    void signal(Signal signal, double pitch) {
        int voice = signalling.start(samples.signal(signal), signal.gain, pitch);
        if (voice != Voices.NONE) {
            double gain = signalling.gain(voice);
            device.play(KNOCKING_VOICES + voice, samples.signal(signal), gain, pitch);
        }
    }

    /** Starts the turn's knocks and goes on to the next turn. */
    void turn() {
        while (!loudest.isEmpty()) {
            play(loudest.remove());
        }
        rolling.turn();
        device.roll(rolling.gain(), rolling.pitch());
        knocking.advance(Scene.STEP);
        signalling.advance(Scene.STEP);
    }

    /**
     * Goes on with the music by some time, s; without a call it stands still.
     *
     * @param volume of it beside all else, more than 0 to 1
     */
    void music(double seconds, double volume) {
        music.advance(seconds, volume, this::playNote);
    }

    private void playNote(int voice, Sample sample, double gain, double pitch) {
        device.play(KNOCKING_VOICES + SIGNALLING_VOICES + voice, sample, gain, pitch);
    }

    private void play(Knock knock) {
        Sample sample = samples.knock(knock.skin());
        int voice = knocking.start(sample, knock.gain(), knock.pitch());
        if (voice != Voices.NONE) {
            device.play(voice, sample, knocking.gain(voice), knock.pitch());
        }
    }

    /** Sets the overall volume, 0 to 1. */
    void volume(double volume) {
        device.volume(volume);
    }

    void close() {
        device.close();
    }
}
