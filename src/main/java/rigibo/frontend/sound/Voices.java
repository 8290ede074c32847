package rigibo.frontend.sound;

import java.util.Arrays;

/**
 * Assigns sounds to a limited number of voices, which together stay below a loudness: at any time
 * the sum of their greatest remaining values is at most that, so that nothing clips. It only
 * counts; the device plays.
 */
final class Voices {

    /** In place of a voice: it is not played. */
    static final int NONE = -1;

    /** Share of full scale below which a sound is not started: −46 dB. */
    private static final double AUDIBLE = 0.005;

    private final double most;
    private final Voice[] voices;

    /** One that plays, or has played out. */
    private static final class Voice {
        Sample sample;
        double gain;
        double pitch;
        double age;

        /** Its greatest value from now on. */
        double loudness() {
            return gain == 0 ? 0 : gain * sample.loudestFrom(age * pitch);
        }
    }

    /** Some voices with their greatest sum, a share of full scale. */
    Voices(int count, double most) {
        this.most = most;
        voices = new Voice[count];
        Arrays.setAll(voices, i -> new Voice());
    }

    /** Their greatest sum from now on, a share of full scale. */
    double loudness() {
        return Arrays.stream(voices).mapToDouble(Voice::loudness).sum();
    }

    /**
     * Starts a sample on the quietest voice, no louder than there is room for.
     *
     * @param gain of the sample, 0 to 1
     * @return the voice, to be played at {@link #gain}; or NONE, where all others are louder or
     *     nothing would be heard
     */
    int start(Sample sample, double gain, double pitch) {
        int quietest = quietest();
        double dropped = voices[quietest].loudness();
        double room = Math.max(0, most - (loudness() - dropped));
        double allowed = Math.min(gain * most, room);
        if (allowed < AUDIBLE || allowed <= dropped) {
            return NONE;
        }
        Voice voice = voices[quietest];
        voice.sample = sample;
        voice.gain = allowed;
        voice.pitch = pitch;
        voice.age = 0;
        return quietest;
    }

    private int quietest() {
        int quietest = 0;
        for (int i = 1; i < voices.length; i++) {
            if (voices[i].loudness() < voices[quietest].loudness()) {
                quietest = i;
            }
        }
        return quietest;
    }

    /** Volume of a voice's sample. */
    double gain(int voice) {
        return voices[voice].gain;
    }

    /** Time passes, s. */
    void advance(double seconds) {
        for (Voice voice : voices) {
            voice.age += seconds;
        }
    }
}
