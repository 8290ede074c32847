package rigibo.frontend.display;

/** A fade to black between two windows, which hides that a new OpenGL context is made. */
final class Curtain {

    /** Number of frames of 1/60 s for which it falls, and rises: about 120 ms each. */
    static final int FRAMES = 7;

    private int left;

    /** Begins to rise: the following frames are ever lighter. */
    void drop() {
        left = FRAMES;
    }

    /** Darkness of the next frame, from 1, black, to 0. */
    double rise() {
        double darkness = left / (double) FRAMES;
        left = Math.max(0, left - 1);
        return darkness;
    }

    /** Darkness of a frame while it falls; frames count from 1 to {@link #FRAMES}. */
    static double fallen(int frame) {
        return frame / (double) FRAMES;
    }
}
