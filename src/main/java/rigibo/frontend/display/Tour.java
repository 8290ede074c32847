package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.GLFW_MOUSE_BUTTON_LEFT;
import static org.lwjgl.glfw.GLFW.GLFW_PRESS;
import static org.lwjgl.glfw.GLFW.GLFW_RELEASE;

import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * Lets the game play itself in real windows and saves pictures. The pointer moves and clicks where
 * GLFW's callbacks deliver their events, so that all code behind them runs.
 */
public final class Tour implements Display.Companion {

    /** Turns of 1/60 s for which a scene that cannot play itself is watched. */
    private static final int WATCHED_TURNS = 6 * FrameClock.RATE;

    /** Turns for which a scene that only waits for a choice is watched. */
    private static final int WAITING_TURNS = 2 * FrameClock.RATE;

    /** Turns after which a level that is not over counts as lost. */
    private static final int MOST_TURNS = 60 * FrameClock.RATE;

    /**
     * Turns for which the end of a demonstration is watched, so that its last picture is at rest.
     */
    private static final int CURTAIN_TURNS = FrameClock.RATE;

    private final List<Stop> stops;
    private final Settings settings;
    private final int width;
    private final int height;
    private final Path folder;
    private final PrintWriter out;
    private final List<String> failures = new ArrayList<>();
    private Scene seen;
    private int current;
    private int turn;
    private int overSince = -1;
    private Optional<Demonstration> demonstration = Optional.empty();

    /**
     * A scene of the tour.
     *
     * @param name of its pictures
     * @param open makes it
     * @param isWaiting whether nothing happens in it but what the player chooses
     */
    public record Stop(String name, Function<Director, Scene> open, boolean isWaiting) {}

    /**
     * A tour that writes PNG files to a folder and its progress to {@code out}.
     *
     * @param settings what the player has chosen
     * @param width of the windows, px
     * @param height of the windows, px
     */
    public Tour(
            List<Stop> stops,
            Settings settings,
            int width,
            int height,
            Path folder,
            PrintWriter out) {
        this.stops = stops;
        this.settings = settings;
        this.width = width;
        this.height = height;
        this.folder = folder;
        this.out = out;
    }

    /**
     * Runs the tour to its end.
     *
     * @return what went wrong: a level that was not won, a complaint of GL or GLFW; empty when all
     *     is well
     * @throws DisplayException when no window comes or a picture cannot be written
     */
    public List<String> run() {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new DisplayException(
                    "cannot write pictures to " + folder + ": " + e.getMessage());
        }
        Display display = new Display(stops.get(0).open(), true);
        display.settings(settings);
        display.accompany(this);
        display.run(null);
        failures.addAll(display.troubles());
        return failures;
    }

    @Override
    public void beforeTurn(Display display, Scene scene) {
        if (scene != seen) {
            seen = scene;
            demonstration = scene.demonstration();
            resize(display.window());
        }
        demonstration.ifPresent(show -> play(show, display.input()));
    }

    private void resize(Window window) {
        if (!settings.isFullScreen()) {
            window.resize(width, height);
        }
    }

    private static void play(Demonstration show, Input input) {
        show.pointer().ifPresent(at -> input.point(at.x(), at.y()));
        show.key().ifPresent(input::press);
        show.click().ifPresent(at -> click(input, at));
    }

    private static void click(Input input, Demonstration.Click at) {
        input.point(at.x(), at.y());
        input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
        input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
    }

    @Override
    public void afterDrawing(Display display, Scene scene) {
        turn++;
        Stop stop = stops.get(current);
        if (!stop.isWaiting() && turn == middle()) {
            picture(display, "-1");
        }
        demonstration
                .flatMap(Demonstration::picture)
                .ifPresent(state -> picture(display, "-" + state));
        if (isDone()) {
            finish(display);
        }
    }

    private int middle() {
        return demonstration.isPresent() ? WAITING_TURNS : WATCHED_TURNS / 2;
    }

    private boolean isDone() {
        if (demonstration.isEmpty()) {
            return turn >= (stops.get(current).isWaiting() ? WAITING_TURNS : WATCHED_TURNS);
        }
        if (overSince < 0 && demonstration.get().isOver()) {
            overSince = turn;
        }
        return turn >= MOST_TURNS || overSince >= 0 && turn >= overSince + CURTAIN_TURNS;
    }

    private void picture(Display display, String state) {
        display.picture(folder.resolve(stops.get(current).name() + state + ".png"));
    }

    private void finish(Display display) {
        picture(display, "");
        String name = stops.get(current).name();
        boolean isLost = demonstration.isPresent() && !demonstration.get().hasSucceeded();
        if (isLost) {
            failures.add(name + " was not won");
        }
        String result = demonstration.isEmpty() ? "seen" : isLost ? "NOT WON" : "won";
        out.printf("  %-24s %-8s %.0f %% of real time%n", name, result, 100 * display.pace());
        current++;
        turn = 0;
        overSince = -1;
        if (current == stops.size()) {
            display.quit();
            return;
        }
        display.show(stops.get(current).open().apply(display));
    }
}
