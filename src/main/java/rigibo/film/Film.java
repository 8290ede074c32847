package rigibo.film;

import rigibo.frontend.display.Display;
import rigibo.frontend.display.Offscreen;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Guest;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** A scene that plays itself, as a moving picture. */
public final class Film {

    private static final int STEPS_PER_SECOND = 60;

    /** 20 frames a second: hundredths, in which GIF counts, divide by it. */
    private static final int STEPS_PER_FRAME = 3;

    private static final int HUNDREDTHS = 5;

    /** How long the end is still watched, and how long its last picture stands. */
    private static final int CURTAIN = 3 * STEPS_PER_SECOND / STEPS_PER_FRAME;

    private static final int STANDING_HUNDREDTHS = 100;

    /** A film that does not end by then never will, frames. */
    private static final int MOST_FRAMES = 120 * STEPS_PER_SECOND / STEPS_PER_FRAME;

    /** One in this many frames is sampled for its colours. */
    private static final int SAMPLED = 12;

    private final Function<Director, Scene> scene;
    private final Offscreen screen;

    /** A film of a scene, shown on a screen twice as wide and high as the film. */
    public Film(Function<Director, Scene> scene, Offscreen screen) {
        this.scene = scene;
        this.screen = screen;
    }

    /** Receives the frames of a show. */
    private interface Viewer {
        void see(int number, boolean isLast) throws IOException;
    }

    /**
     * Plays the scene twice, once for its colours and once for the file.
     *
     * @return the number of frames
     * @throws IOException when the file cannot be written
     * @throws IllegalArgumentException when the scene does not play itself, or never ends
     */
    public int write(Path file, String language) throws IOException {
        // A display that never opens its window: its guest only looks on.
        Director audience = new Display(scene, scene, new Guest(Settings.initial(language)));
        List<Frame> samples = new ArrayList<>();
        Scene first = scene.apply(audience);
        int frames =
                play(
                        first,
                        (number, isLast) -> {
                            if (isLast || number % SAMPLED == 0) {
                                samples.add(frame(first, number));
                            }
                        });
        Files.deleteIfExists(file);
        try (GifFile gif = new GifFile(file, Palette.of(samples))) {
            Scene second = scene.apply(audience);
            play(
                    second,
                    (number, isLast) ->
                            gif.add(
                                    frame(second, number),
                                    isLast ? STANDING_HUNDREDTHS : HUNDREDTHS));
        }
        return frames;
    }

    private Frame frame(Scene shown, int number) {
        int[] colors = screen.picture(shown, number * HUNDREDTHS / 100.0);
        return new Frame(screen.width(), screen.height(), colors).halved();
    }

    private static int play(Scene shown, Viewer viewer) throws IOException {
        Demonstration demonstration =
                shown.demonstration()
                        .orElseThrow(
                                () ->
                                        new IllegalArgumentException(
                                                shown.title() + " does not play itself"));
        int left = CURTAIN;
        for (int number = 0; number < MOST_FRAMES; number++) {
            left -= demonstration.isOver() ? 1 : 0;
            viewer.see(number, left == 0);
            if (left == 0) {
                return number + 1;
            }
            for (int step = 0; step < STEPS_PER_FRAME; step++) {
                shown.step();
            }
        }
        throw new IllegalArgumentException(shown.title() + " does not end");
    }
}
