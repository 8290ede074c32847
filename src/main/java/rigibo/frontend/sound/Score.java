package rigibo.frontend.sound;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Queue;
import java.util.SplittableRandom;

/**
 * Composes calm music without end; a seed always gives the same notes.
 *
 * <p>Sections of four bars follow each other, a chord to each bar: a bass, a broken chord, and for
 * three sections of four a melody out of a motif that comes back. All of it is in C: chords of its
 * scale, the melody of five tones that go with all of them.
 */
final class Score {

    /** Length of an eighth, s: 66 quarters a minute, a slow walk. */
    static final double EIGHTH = 0.4545;

    private static final int EIGHTHS = 8;
    private static final int BARS = 4;

    /** Sections until there is another motif, the last of them without melody. */
    private static final int MOTIF_SECTIONS = 4;

    /** Time before the first note, s. */
    private static final double SILENCE = 2;

    /** Roots of the chords of a section, semitones above C. */
    private static final int[][] PROGRESSIONS = {
        {0, 9, 5, 7}, {0, 5, 9, 7}, {9, 5, 0, 7}, {5, 0, 2, 9}, {0, 4, 5, 5}
    };

    /** The scale of C major, semitones. */
    private static final List<Integer> SCALE = List.of(0, 2, 4, 5, 7, 9, 11);

    /** Tones of melodies: without the fourth and the seventh. */
    private static final int[] PENTATONIC = {0, 2, 4, 7, 9};

    /** Lowest tones by number of the keyboard, 69 for 440 Hz: F₂, G₃, C₅. */
    private static final int BASS_FROM = 41;

    private static final int CHORD_FROM = 55;
    private static final int MELODY_FROM = 72;

    /** In place of a tone of a motif. */
    private static final int REST = -1;

    private static final double BASS_GAIN = 0.6;
    private static final double CHORD_GAIN = 0.36;
    private static final double MELODY_GAIN = 0.4;

    private final SplittableRandom random;
    private final Queue<Note> notes = new ArrayDeque<>();
    private int sections;
    private int[] progression = PROGRESSIONS[0];
    private int[] motif = {};

    Score(long seed) {
        random = new SplittableRandom(seed);
    }

    /** The next note, in the order of their starts. */
    Note next() {
        while (notes.isEmpty()) {
            compose();
        }
        return notes.remove();
    }

    private void compose() {
        if (sections % MOTIF_SECTIONS == 0) {
            motif = motif();
        }
        if (sections % 2 == 0) {
            progression = PROGRESSIONS[random.nextInt(PROGRESSIONS.length)];
        }
        List<Note> section = new ArrayList<>();
        boolean[] rhythm = rhythm();
        for (int bar = 0; bar < BARS; bar++) {
            bass(section, bar);
            chord(section, bar, rhythm);
            if (sections % MOTIF_SECTIONS < MOTIF_SECTIONS - 1) {
                melody(section, bar);
            }
        }
        section.sort(Comparator.comparingDouble(Note::start));
        notes.addAll(section);
        sections++;
    }

    /** Eighths of a bar in which the chord is heard: three or four, the second one seldom. */
    private boolean[] rhythm() {
        boolean[] rhythm = new boolean[EIGHTHS];
        for (int i = 1; i < EIGHTHS; i++) {
            rhythm[i] = random.nextInt(100) < (i % 2 == 0 ? 65 : 30);
        }
        return rhythm;
    }

    /** Two bars of steps on the five tones, never far from the one before. */
    private int[] motif() {
        int[] drawn = new int[2 * EIGHTHS];
        int step = random.nextInt(PENTATONIC.length);
        for (int i = 0; i < drawn.length; i++) {
            step = Math.max(0, Math.min(7, step + random.nextInt(5) - 2));
            boolean isPlayed = random.nextInt(100) < (i % 4 == 0 ? 70 : i % 2 == 0 ? 40 : 15);
            drawn[i] = isPlayed ? step : REST;
        }
        return drawn;
    }

    private void bass(List<Note> section, int bar) {
        int root = from(BASS_FROM, progression[bar]);
        add(section, bar, 0, Instrument.BASS, root, BASS_GAIN);
        if (random.nextInt(100) < 40) {
            int fifth = from(BASS_FROM, progression[bar] + 7);
            add(section, bar, 4, Instrument.BASS, fifth, 0.6 * BASS_GAIN);
        }
    }

    /** The chord's tones, up and down again. */
    private void chord(List<Note> section, int bar, boolean[] rhythm) {
        int degree = SCALE.indexOf(progression[bar]);
        int tone = 0;
        for (int i = 0; i < EIGHTHS; i++) {
            if (rhythm[i]) {
                int third = tone % 4 == 3 ? 1 : tone % 4;
                int semitones = SCALE.get((degree + 2 * third) % SCALE.size());
                double accent = i == 4 ? 1 : 0.75 + 0.15 * random.nextDouble();
                int key = from(CHORD_FROM, semitones);
                add(section, bar, i, Instrument.BAR, key, accent * CHORD_GAIN);
                tone++;
            }
        }
    }

    /** The motif; its second time it ends elsewhere. */
    private void melody(List<Note> section, int bar) {
        for (int i = 0; i < EIGHTHS; i++) {
            int place = bar % 2 * EIGHTHS + i;
            int step = motif[place];
            boolean isEnding = bar == BARS - 1 && i >= EIGHTHS / 2;
            if (step != REST && !(isEnding && random.nextInt(2) == 0)) {
                int octave = step / PENTATONIC.length;
                int key = MELODY_FROM + 12 * octave + PENTATONIC[step % PENTATONIC.length];
                double accent = 0.7 + 0.3 * random.nextDouble();
                add(section, bar, i, Instrument.BELL, key, accent * MELODY_GAIN);
            }
        }
    }

    /** The lowest key, from a given one on, that lies the given number of semitones above a C. */
    private static int from(int lowest, int semitones) {
        return lowest + Math.floorMod(semitones - lowest, 12);
    }

    private void add(List<Note> section, int bar, int eighth, Instrument by, int key, double gain) {
        double start = SILENCE + EIGHTH * ((sections * BARS + bar) * (double) EIGHTHS + eighth);
        section.add(new Note(start, by, 440 * Math.pow(2, (key - 69) / 12.0), gain));
    }
}
