package rigibo.frontend.draw;

import rigibo.frontend.scene.Settings;

import java.util.Locale;

/**
 * Chooses the detail of drawing: the player's setting, or, where OpenGL has no graphics card, by
 * the rate of frames. Once frames came too late the detail stays low, because switching back and
 * forth would be worse than either.
 */
public final class DetailChoice {

    /** Frame time, ns, above which a step of many bodies has too little left of 16.7 ms. */
    private static final long LATE = 12_000_000;

    /** Number of frames after which detail is chosen; it becomes low if half of them are late. */
    private static final int FRAMES = 120;

    private static final String[] SOFTWARE = {"llvmpipe", "softpipe", "swrast", "swiftshader"};

    private boolean isSoftware;
    private boolean isSlow;
    private int frames;
    private int late;

    /** Sets the name of the renderer, {@code GL_RENDERER}; called for every window. */
    public void renderer(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        isSoftware = false;
        for (String software : SOFTWARE) {
            isSoftware |= lower.contains(software);
        }
    }

    /** Records the time that a frame took to draw, ns. */
    public void drawn(long nanos) {
        frames++;
        late += nanos > LATE ? 1 : 0;
        if (frames == FRAMES) {
            isSlow |= isSoftware && 2 * late > frames;
            frames = 0;
            late = 0;
        }
    }

    /** The detail of the next frame. */
    public Detail detail(Settings.Detail chosen) {
        return switch (chosen) {
            case AUTOMATIC -> isSlow ? Detail.LITE : Detail.FULL;
            case FULL -> Detail.FULL;
            case LITE -> Detail.LITE;
        };
    }
}
