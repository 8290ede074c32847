package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Random input for a test of the whole game: the pointer moves, clicks and drags anywhere; keys
 * with and without a meaning are pressed; windows are resized, lose the focus and give way to
 * others. Every event enters where GLFW's callbacks deliver theirs.
 */
public final class Monkey implements Display.Companion {

    /** Most turns in one window. */
    private static final int MOST_TURNS = 4 * FrameClock.RATE;

    /** Average number of turns between rare events: a new size, or a lost focus. */
    private static final int SELDOM = 120;

    private static final int[] KEYS =
            IntStream.concat(
                            IntStream.rangeClosed(GLFW_KEY_SPACE, GLFW_KEY_GRAVE_ACCENT),
                            IntStream.rangeClosed(GLFW_KEY_ESCAPE, GLFW_KEY_F12))
                    .toArray();

    private final List<SceneEntry> entries;
    private final SplittableRandom random;
    private final int turns;
    private Report report = new Report(0, 0, List.of());
    private Scene seen;
    private int turn;
    private int leaveAt;
    private int windows;

    private Monkey(List<SceneEntry> entries, int turns, long seed) {
        this.entries = entries;
        this.turns = turns;
        random = new SplittableRandom(seed);
    }

    /**
     * The result of a run that threw no exception.
     *
     * @param turns of the loop, each 1/60 s
     * @param windows that were opened
     * @param troubles errors that GLFW and OpenGL reported
     */
    public record Report(int turns, int windows, List<String> troubles) {}

    /**
     * Plays for a number of turns; the input depends only on the seed. The player is a guest, whose
     * files are not touched.
     *
     * @throws DisplayException when no window can be opened
     */
    public static Report play(
            Function<Director, Scene> menu, List<SceneEntry> entries, int turns, long seed) {
        Monkey monkey = new Monkey(entries, turns, seed);
        while (monkey.turn < turns) {
            // It also finds the way out, and comes back.
            Display display = new Display(menu, true);
            display.accompany(monkey);
            display.run(null);
            monkey.note(display);
        }
        return monkey.report;
    }

    private void note(Display display) {
        List<String> troubles =
                Stream.concat(report.troubles().stream(), display.troubles().stream()).toList();
        report = new Report(turn, windows, troubles);
    }

    @Override
    public void beforeTurn(Display display, Scene scene) {
        if (scene != seen) {
            seen = scene;
            windows++;
            leaveAt = turn + 1 + random.nextInt(MOST_TURNS);
        }
        turn++;
        if (turn >= turns) {
            display.quit();
        } else if (turn >= leaveAt) {
            display.show(entries.get(random.nextInt(entries.size())).open().apply(display));
        } else {
            act(display);
        }
    }

    private void act(Display display) {
        Input input = display.input();
        switch (random.nextInt(8)) {
            case 0, 1 -> input.cursor(random.nextDouble(-20, 740), random.nextDouble(-20, 820));
            case 2 -> input.mouseButton(button(), GLFW_PRESS);
            case 3 -> input.mouseButton(button(), GLFW_RELEASE);
            case 4 -> input.scroll(random.nextDouble(-3, 3));
            case 5 -> key(input);
            case 6 -> input.character(random.nextInt(' ', 0x2FF));
            default -> seldom(display);
        }
    }

    private int button() {
        return random.nextInt(GLFW_MOUSE_BUTTON_LAST + 1);
    }

    private void key(Input input) {
        int key = KEYS[random.nextInt(KEYS.length)];
        input.modifiers(random.nextInt(4) == 0 ? GLFW_MOD_CONTROL : 0);
        input.key(key, GLFW_PRESS);
        input.key(key, GLFW_RELEASE);
    }

    private void seldom(Display display) {
        if (random.nextInt(SELDOM) == 0) {
            display.window().resize(random.nextInt(100, 1200), random.nextInt(100, 1000));
        } else if (random.nextInt(SELDOM) == 0) {
            display.window().hideAndShow();
        }
    }
}
