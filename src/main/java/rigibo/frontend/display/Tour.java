package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.GLFW_MOUSE_BUTTON_LEFT;
import static org.lwjgl.glfw.GLFW.GLFW_PRESS;
import static org.lwjgl.glfw.GLFW.GLFW_RELEASE;

import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
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
 * The game plays itself in real windows and keeps pictures. The pointer moves and clicks where
 * GLFW's callbacks deliver their events, so that everything behind them is at work.
 */
public final class Tour implements Display.Companion {

    /** How long a scene that cannot play itself is watched, turns of 1/60 s. */
    private static final int WATCHED_TURNS = 6 * FrameClock.RATE;

    /** How long the menu is watched. */
    private static final int MENU_TURNS = 2 * FrameClock.RATE;

    /** A level that is not over by then is lost. */
    private static final int MOST_TURNS = 60 * FrameClock.RATE;

    /** How long the end of a demonstration is watched, so that its last picture is at rest. */
    private static final int CURTAIN_TURNS = FrameClock.RATE;

    private final List<SceneEntry> entries;
    private final Path folder;
    private final PrintWriter out;
    private final List<String> failures = new ArrayList<>();
    private int next = -1;
    private int turn;
    private int overSince = -1;
    private Optional<Demonstration> demonstration = Optional.empty();

    /** A tour of scenes that writes PNG files to a folder and its progress to {@code out}. */
    public Tour(List<SceneEntry> entries, Path folder, PrintWriter out) {
        this.entries = entries;
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
    public List<String> run(Function<Director, Scene> menu) {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new DisplayException(
                    "cannot write pictures to " + folder + ": " + e.getMessage());
        }
        Display display = new Display(menu, true);
        // Pictures show all there is, however slowly it is drawn.
        display.settings(display.settings().withDetail(Settings.Detail.FULL));
        display.accompany(this);
        display.run(null);
        failures.addAll(display.troubles());
        return failures;
    }

    @Override
    public void beforeTurn(Display display, Scene scene) {
        demonstration.ifPresent(show -> play(show, display.input()));
    }

    private static void play(Demonstration show, Input input) {
        show.pointer().ifPresent(at -> input.cursor(at.x(), at.y()));
        show.key().ifPresent(input::press);
        show.click().ifPresent(at -> click(input, at));
    }

    private static void click(Input input, Demonstration.Click at) {
        input.cursor(at.x(), at.y());
        input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
        input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
    }

    @Override
    public void afterDrawing(Display display, Scene scene) {
        turn++;
        boolean isMiddle = turn == length() / 2 && demonstration.isEmpty();
        if (isMiddle && next >= 0) {
            display.picture(folder.resolve(name() + "-1.png"));
        }
        if (demonstration.isPresent() && overSince < 0 && turn == 2 * FrameClock.RATE) {
            display.picture(folder.resolve(name() + "-1.png"));
        }
        demonstration
                .flatMap(Demonstration::picture)
                .ifPresent(state -> display.picture(folder.resolve(name() + "-" + state + ".png")));
        if (isDone()) {
            finish(display);
        }
    }

    private int length() {
        return next < 0 ? MENU_TURNS : WATCHED_TURNS;
    }

    private boolean isDone() {
        if (demonstration.isEmpty()) {
            return turn >= length();
        }
        if (overSince < 0 && demonstration.get().isOver()) {
            overSince = turn;
        }
        return turn >= MOST_TURNS || overSince >= 0 && turn >= overSince + CURTAIN_TURNS;
    }

    private String name() {
        return next < 0 ? "menu" : entries.get(next).name();
    }

    private void finish(Display display) {
        display.picture(folder.resolve(name() + ".png"));
        boolean isLost = demonstration.isPresent() && !demonstration.get().hasSucceeded();
        if (isLost) {
            failures.add(name() + " was not won");
        }
        String result = demonstration.isEmpty() ? "seen" : isLost ? "NOT WON" : "won";
        out.printf("  %-24s %-8s %.0f %% of real time%n", name(), result, 100 * display.pace());
        next++;
        turn = 0;
        overSince = -1;
        if (next == entries.size()) {
            display.quit();
            return;
        }
        Scene scene = entries.get(next).open().apply(display);
        demonstration = scene.demonstration();
        display.show(scene);
    }
}
