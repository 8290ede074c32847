package rigibo.frontend.display;

/**
 * The dark between two windows while the new OpenGL context is made; it fades in and out over some
 * frames.
 */
final class Curtain {

    /** Of 1/60 s each, either way: about 120 ms. */
    static final int FRAMES = 7;

    private int left;

    /** It is down: the frames to come are lighter and lighter. */
    void drop() {
        left = FRAMES;
    }

    /** How dark the next frame is, from 1, black, to 0. */
    double rise() {
        double darkness = left / (double) FRAMES;
        left = Math.max(0, left - 1);
        return darkness;
    }

    /** How dark a frame is while it falls; frames count from 1 to {@link #FRAMES}. */
    static double fallen(int frame) {
        return frame / (double) FRAMES;
    }
}
