package rigibo.frontend.sound;

/** Plays a score: starts each note when its time has come, as far as there are voices for it. */
final class Music {

    static final int VOICES = 10;

    /** Share of full scale for the music, quieter than all sounds that tell something. */
    static final double MOST = 0.18;

    private final Score score;
    private final Voices voices = new Voices(VOICES, MOST);
    private final Samples samples;
    private Note next;
    private double time;

    /** Plays notes on a device. */
    interface Player {

        /** Starts a sample on one of {@link #VOICES} voices, in place of what that plays. */
        void play(int voice, Sample sample, double gain, double pitch);
    }

    Music(Score score, Samples samples) {
        this.score = score;
        this.samples = samples;
        next = score.next();
    }

    /**
     * Goes on by some time, s.
     *
     * @param volume what the notes are multiplied with, more than 0 to 1
     */
    void advance(double seconds, double volume, Player player) {
        time += seconds;
        voices.advance(seconds);
        while (next.start() <= time) {
            play(next, volume, player);
            next = score.next();
        }
    }

    private void play(Note note, double volume, Player player) {
        Sample sample = samples.instrument(note.instrument());
        double pitch = note.instrument().pitch(note.frequency());
        int voice = voices.start(sample, note.gain(), pitch);
        if (voice != Voices.NONE) {
            player.play(voice, sample, voices.gain(voice) * volume, pitch);
        }
    }
}
