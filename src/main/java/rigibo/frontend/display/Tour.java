package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.GLFW_MOUSE_BUTTON_LEFT;
import static org.lwjgl.glfw.GLFW.GLFW_PRESS;
import static org.lwjgl.glfw.GLFW.GLFW_RELEASE;

import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;

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

    /** Turns of a demonstration until its first picture. */
    private static final int EARLY = 2 * FrameClock.RATE;

    /** Turns after which a level that is not over counts as lost. */
    private static final int MOST_TURNS = 60 * FrameClock.RATE;

    /**
     * Turns for which the end of a demonstration is watched, so that its last picture is at rest.
     */
    private static final int CURTAIN_TURNS = FrameClock.RATE;

    /** Turns for which a scene is seen before it is left by a move. */
    private static final int GLANCE = FrameClock.RATE;

    /** Turns in which a move must have become possible; levels take a while to be made. */
    private static final int PATIENCE = 300 * FrameClock.RATE;

    private final List<Stop> stops;
    private final int width;
    private final int height;
    private final Path folder;
    private final PrintWriter out;
    private final List<String> failures = new ArrayList<>();
    private Scene seen;
    private int current;
    private int moves;

    /** Turns since the scene was opened, or since the last move. */
    private int turn;

    private int overSince = -1;
    private Optional<Demonstration> demonstration = Optional.empty();

    /**
     * A stop of the tour.
     *
     * @param name of its pictures
     * @param open makes its first scene
     * @param moves that lead to the scene it is about
     * @param seconds for which that scene is watched, unless it plays itself
     */
    public record Stop(String name, Function<Director, Scene> open, List<Move> moves, int seconds) {

        /** For a scene in which nothing happens but what the player chooses, s. */
        public static final int WAITING = 2;

        /** For a scene in which something moves, s. */
        public static final int MOVING = 6;
    }

    /**
     * A tour that writes PNG files to a folder and its progress to {@code out}.
     *
     * @param width of the windows, px
     * @param height of the windows, px
     */
    public Tour(List<Stop> stops, int width, int height, Path folder, PrintWriter out) {
        this.stops = stops;
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
    public List<String> run(Display display) {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new DisplayException(
                    "cannot write pictures to " + folder + ": " + e.getMessage());
        }
        display.accompany(this);
        display.run(stops.get(0).open());
        failures.addAll(display.troubles());
        return failures;
    }

    private Stop stop() {
        return stops.get(current);
    }

    private boolean hasArrived() {
        return moves == stop().moves().size();
    }

    @Override
    public void beforeTurn(Display display, Scene scene) {
        if (scene != seen) {
            seen = scene;
            begin();
            if (!display.settings().isFullScreen()) {
                display.window().resize(width, height);
            }
        }
        demonstration.ifPresent(show -> play(show, display.input()));
    }

    /** Begins with a scene, or with the scene that a move leads to. */
    private void begin() {
        turn = 0;
        overSince = -1;
        boolean plays = hasArrived() || stop().moves().get(moves) instanceof Move.Watch;
        demonstration = plays ? seen.demonstration() : Optional.empty();
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
        if (!hasArrived()) {
            goOn(display, scene);
            return;
        }
        if (stop().seconds() > Stop.WAITING && turn == middle()) {
            picture(display, "-1");
        }
        demonstration
                .flatMap(Demonstration::picture)
                .ifPresent(state -> picture(display, "-" + state));
        if (isDone()) {
            finish(display);
        }
    }

    /** Makes the next move once the scene was seen and lets it be made. */
    private void goOn(Display display, Scene scene) {
        if (turn == GLANCE && moves > 0) {
            picture(display, "-before-" + (moves + 1));
        }
        if (turn > GLANCE && isMade(display, scene, stop().moves().get(moves))) {
            moves++;
            begin();
        } else if (turn > PATIENCE) {
            failures.add(stop().name() + " came to no end: " + stop().moves().get(moves));
            next(display);
        }
    }

    private boolean isMade(Display display, Scene scene, Move move) {
        if (move instanceof Move.Click click) {
            Optional<Demonstration.Click> at = Signpost.to(display.words().of(click.key()), scene);
            at.ifPresent(place -> click(display.input(), place));
            return at.isPresent();
        }
        if (move instanceof Move.Watch) {
            return demonstration.isEmpty() || isOver();
        }
        if (move instanceof Move.Press press) {
            display.input().press(press.key());
        } else if (move instanceof Move.Drop drop) {
            display.dropped(List.of(drop.file()));
        }
        return true;
    }

    private int middle() {
        return demonstration.isPresent() ? EARLY : stop().seconds() * FrameClock.RATE / 2;
    }

    private boolean isDone() {
        return demonstration.isEmpty() ? turn >= stop().seconds() * FrameClock.RATE : isOver();
    }

    private boolean isOver() {
        if (overSince < 0 && demonstration.orElseThrow().isOver()) {
            overSince = turn;
        }
        return turn >= MOST_TURNS || overSince >= 0 && turn >= overSince + CURTAIN_TURNS;
    }

    private void picture(Display display, String state) {
        display.picture(folder.resolve(stop().name() + state + ".png"));
    }

    private void finish(Display display) {
        picture(display, "");
        String name = stop().name();
        boolean isLost = demonstration.isPresent() && !demonstration.get().hasSucceeded();
        if (isLost) {
            failures.add(name + " was not won");
        }
        String result = demonstration.isEmpty() ? "seen" : isLost ? "NOT WON" : "won";
        out.printf("  %-24s %-8s %.0f %% of real time%n", name, result, 100 * display.pace());
        next(display);
    }

    private void next(Display display) {
        current++;
        moves = 0;
        if (current == stops.size()) {
            display.quit();
        } else {
            display.show(stop().open().apply(display));
        }
    }
}
