package rigibo.frontend.draw;

import rigibo.frontend.scene.Settings;

import java.util.Locale;

/**
 * Chooses the detail of drawing: the player's setting, or, where OpenGL has no graphics card, what
 * some pictures take before a window is shown. Within a window the detail never changes by itself,
 * and once it is low it stays low: switching back and forth would be worse than either.
 */
public final class DetailChoice {

    /** Time for a picture, ns, above which a step of many bodies has too little left of 16.7 ms. */
    private static final long LATE = 12_000_000;

    /** First pictures of a window, which are not counted: scenery and shaders are made in them. */
    private static final int FIRST = 2;

    /** Pictures after them; the detail becomes low if most are late. */
    private static final int COUNTED = 3;

    private static final String[] SOFTWARE = {"llvmpipe", "softpipe", "swrast", "swiftshader"};

    private boolean isSoftware;
    private boolean isSlow;
    private int tried;
    private int late;

    /** Sets the name of the renderer, {@code GL_RENDERER}; called for every window. */
    public void renderer(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        isSoftware = false;
        for (String software : SOFTWARE) {
            isSoftware |= lower.contains(software);
        }
        tried = 0;
        late = 0;
    }

    /** Whether a picture is to be drawn for trial, before the window is shown. */
    public boolean isOpen(Settings.Detail chosen) {
        boolean isAsked = chosen == Settings.Detail.AUTOMATIC && isSoftware && !isSlow;
        return isAsked && tried < FIRST + COUNTED;
    }

    /** Notes how long a picture for trial took to draw, ns. */
    public void tried(long nanos) {
        tried++;
        late += tried > FIRST && nanos > LATE ? 1 : 0;
        isSlow |= 2 * late > COUNTED;
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
