package rigibo.frontend.sound;

import rigibo.frontend.scene.Deed;

import java.util.List;

/** The sounds of the game besides the knocks of its bodies. */
enum Signal {
    /** A box is gone: up like a bubble. */
    POP(0.8, new Tone(0, 260, 820, 1, 0.05), Tone.steady(520, 0.2, 0.02)),
    /** Two blades meet: two short, bright clicks. */
    SNIP(0.8, Tone.steady(2350, 0.6, 0.008), new Tone(0.06, 3100, 2700, 1, 0.012)),
    /** A pin slides out: up, and a ring of brass. */
    PULL(0.8, new Tone(0, 420, 1250, 0.8, 0.06), new Tone(0.1, 1870, 1870, 0.7, 0.09)),
    /** A lever and a motor that starts. */
    SWITCH_ON(0.7, Tone.steady(1400, 0.7, 0.008), new Tone(0.03, 90, 210, 1, 0.11)),
    /** A lever and a motor that runs out. */
    SWITCH_OFF(0.7, Tone.steady(1100, 0.7, 0.008), new Tone(0.03, 190, 70, 1, 0.09)),
    /** Ice that cracks and then rings. */
    FREEZE(
            0.7,
            Tone.steady(3300, 0.5, 0.006),
            new Tone(0.03, 2650, 2500, 0.6, 0.05),
            new Tone(0.06, 1570, 1540, 1, 0.14)),
    /** A match. */
    FUSE(0.5, new Tone(0, 5200, 3400, 0.6, 0.02), new Tone(0.04, 4300, 6100, 0.8, 0.07)),
    /** Low, and falling. */
    BLAST(1, new Tone(0, 140, 38, 1, 0.16), new Tone(0, 420, 60, 0.7, 0.05)),
    /** Embers that hiss and sink away. */
    MELT(
            0.6,
            new Tone(0, 3900, 2300, 0.4, 0.12),
            new Tone(0.02, 5100, 2900, 0.3, 0.09),
            new Tone(0.05, 310, 95, 1, 0.16)),
    /** Not now: twice the same low note. */
    REFUSE(0.7, Tone.steady(165, 1, 0.03), new Tone(0.11, 165, 165, 1, 0.04)),
    /** A bright dot, played higher the longer the hold has lasted. */
    TICK(0.5, Tone.steady(880, 1, 0.025), Tone.steady(2640, 0.2, 0.01)),
    /** C major, upwards. */
    CHORD(
            1,
            new Tone(0.00, 523.25, 523.25, 1, 0.22),
            new Tone(0.09, 659.26, 659.26, 1, 0.22),
            new Tone(0.18, 783.99, 783.99, 1, 0.22),
            new Tone(0.27, 1046.50, 1046.50, 1, 0.17)),
    /** Two notes that sink. */
    FAIL(0.8, new Tone(0, 330, 262, 1, 0.10), new Tone(0.22, 247, 175, 1, 0.16)),
    /** A dry click. */
    PRESS(0.5, Tone.steady(640, 1, 0.012), Tone.steady(1910, 0.4, 0.006));

    /** How loud it is played, a share of what signals may be together. */
    final double gain;

    private final List<Tone> tones;

    Signal(double gain, Tone... tones) {
        this.gain = gain;
        this.tones = List.of(tones);
    }

    static Signal of(Deed deed) {
        return switch (deed) {
            case SNIP -> SNIP;
            case PULL -> PULL;
            case SWITCH_ON -> SWITCH_ON;
            case SWITCH_OFF -> SWITCH_OFF;
            case FREEZE -> FREEZE;
            case FUSE -> FUSE;
            case BLAST -> BLAST;
            case MELT -> MELT;
        };
    }

    Sample sample() {
        return Sample.of(tones, 0);
    }
}
