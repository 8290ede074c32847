package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import rigibo.frontend.draw.DetailChoice;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Guest;
import rigibo.frontend.scene.Player;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Sounds;
import rigibo.frontend.scene.Words;
import rigibo.frontend.sound.Speaker;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * Owns the window and runs the loop until the window is closed or Esc is pressed: {@code
 * inputListener, doStep, renderDisplay, updateDisplay}, named and ordered as in the origin report.
 * Every scene has a window of its own; the present one is destroyed before the next one starts.
 */
public final class Display implements Director {

    private final Function<Director, Scene> menu;
    private final Function<Director, Scene> levels;
    private final boolean vsync;
    private final Troubles troubles = new Troubles();
    private final FrameClock clock;
    private final Speaker speaker = new Speaker();
    private final WindowSize size = new WindowSize();
    private final Curtain curtain = new Curtain();
    private final DetailChoice choice = new DetailChoice();
    private final Player player;
    private final Toast toast = new Toast();
    private final Gamepad gamepad = new Gamepad(button -> window().gamepad(button));
    private Optional<BiFunction<Director, List<Path>, Scene>> opener = Optional.empty();
    private Optional<BiFunction<Director, String, Optional<Scene>>> decoder = Optional.empty();
    private Words words;
    private Window window;
    private Scene scene;
    private Scene wanted;
    private Optional<Path> toBeSaved = Optional.empty();
    private boolean isMenu;
    private boolean isOver;
    private Optional<Companion> companion = Optional.empty();

    /** Takes part in every turn of the loop, as the tour does. */
    interface Companion {

        /**
         * Most steps of a turn, 1 to {@link FrameClock#MOST_STEPS}. A guest that acts once per turn
         * does the same in every run only if each turn makes one step.
         */
        default int mostSteps() {
            return 1;
        }

        /** Before the scene's step. */
        default void beforeTurn(Display display, Scene scene) {}

        /** After the scene was drawn, before it is shown. */
        default void afterDrawing(Display display, Scene scene) {}
    }

    /** A display with a guest, in English; with vsync, or without it for measurements. */
    public Display(Function<Director, Scene> menu, boolean vsync) {
        this(menu, menu, new Guest(Settings.initial("en")), vsync, new FrameClock());
    }

    /** A display with a guest for tests, which bring their own clock; without vsync. */
    Display(Function<Director, Scene> menu, FrameClock clock) {
        this(menu, menu, new Guest(Settings.initial("en")), false, clock);
    }

    /** A display for a player, who can go back to the menu or to the list of levels. */
    public Display(
            Function<Director, Scene> menu, Function<Director, Scene> levels, Player player) {
        this(menu, levels, player, true, new FrameClock());
    }

    private Display(
            Function<Director, Scene> menu,
            Function<Director, Scene> levels,
            Player player,
            boolean vsync,
            FrameClock clock) {
        this.menu = menu;
        this.levels = levels;
        this.player = player;
        this.vsync = vsync;
        this.clock = clock;
        words = new Words(player.settings());
        speaker.settings(player.settings());
    }

    /** Turns sound on if the machine has any; without it scenes are silent. */
    public void plugIn() {
        speaker.plugIn();
    }

    /**
     * Opens a scene, or the menu if none is given, and loops until the player leaves.
     *
     * @throws DisplayException when no window can be opened, saying why
     */
    public void run(Function<Director, Scene> first) {
        troubles.listen();
        if (!glfwInit()) {
            throw new DisplayException("RigiBo cannot open a window: " + troubles.last());
        }
        try {
            open(first == null ? menu : first);
            while (!isOver) {
                turn();
            }
        } finally {
            closeWindow();
            glfwTerminate();
            speaker.close();
        }
    }

    /** Complaints of GLFW and OpenGL. */
    public List<String> troubles() {
        return troubles.all();
    }

    /** Share of real time at which the loop runs. */
    public double pace() {
        return clock.pace();
    }

    @Override
    public void show(Scene next) {
        wanted = next;
        isMenu = false;
    }

    @Override
    public void showMenu() {
        wanted = menu.apply(this);
        isMenu = true;
    }

    @Override
    public void showLevels() {
        show(levels.apply(this));
    }

    @Override
    public void quit() {
        isOver = true;
    }

    @Override
    public Player player() {
        return player;
    }

    @Override
    public void settings(Settings changed) {
        player.settings(changed);
        speaker.settings(changed);
        words = new Words(changed);
        if (window != null) {
            window.fill(changed.isFullScreen());
        }
    }

    /** Switches full screen on or off. */
    void toggleFullScreen() {
        settings(settings().withFullScreen(!settings().isFullScreen()));
    }

    /** Switches sound on or off, and shows a message, since silence could have any cause. */
    void toggleMute() {
        settings(settings().withMuted(!settings().isMuted()));
        toast.say(words.of(settings().isMuted() ? "toast.muted" : "toast.sounding"));
    }

    Toast toast() {
        return toast;
    }

    @Override
    public Words words() {
        return words;
    }

    @Override
    public Sounds sounds() {
        return speaker;
    }

    /** Sets the function that makes a scene of files which are dropped on a window. */
    public void opensFilesBy(BiFunction<Director, List<Path>, Scene> opening) {
        opener = Optional.of(opening);
    }

    /**
     * Sets the function that makes a scene from pasted text; it returns none if the text is not a
     * code.
     */
    public void opensCodesBy(BiFunction<Director, String, Optional<Scene>> decoding) {
        decoder = Optional.of(decoding);
    }

    @Override
    public void say(String told) {
        toast.say(told);
    }

    @Override
    public void copy(String text) {
        window.copy(text);
        toast.say(words.of("toast.copied", text.length()));
    }

    @Override
    public void paste() {
        String text = window.pasted();
        if (!scene.pasted(text)) {
            decoder.flatMap(decoding -> decoding.apply(this, text))
                    .ifPresentOrElse(this::show, () -> toast.say(words.of("toast.no-code")));
        }
    }

    @Override
    public void savePicture(Path file) {
        toBeSaved = Optional.of(file);
    }

    private void save(Path file) {
        toBeSaved = Optional.empty();
        try {
            picture(file);
        } catch (DisplayException refused) {
            toast.say(words.of("toast.no-picture", file));
        }
    }

    void dropped(List<Path> files) {
        opener.map(opening -> opening.apply(this, files)).ifPresent(this::show);
    }

    void accompany(Companion beside) {
        companion = Optional.of(beside);
    }

    Input input() {
        return window.input();
    }

    Window window() {
        return window;
    }

    void picture(Path file) {
        window.picture(file);
    }

    private void open(Function<Director, Scene> maker) {
        wanted = maker.apply(this);
        isMenu = maker == menu;
        change();
    }

    /**
     * Input is delivered before the first step. A scene that is to be left makes no further step.
     */
    private void turn() {
        inputListener();
        do {
            doStep();
        } while (clock.isAnotherDueOf(mostSteps()) && wanted == null && !isOver);
        renderDisplay();
        updateDisplay();
        change();
    }

    private int mostSteps() {
        return companion.map(Companion::mostSteps).orElse(FrameClock.MOST_STEPS);
    }

    private void inputListener() {
        glfwPollEvents();
        GamepadDevices.poll(gamepad);
        companion.ifPresent(beside -> beside.beforeTurn(this, scene));
        if (window.wantsToClose()) {
            if (isMenu) {
                isOver = true;
            } else {
                showMenu();
            }
        }
    }

    private void doStep() {
        scene.step();
        speaker.turn();
    }

    private void renderDisplay() {
        window.render(settings().detail(), curtain.rise());
        toBeSaved.ifPresent(this::save);
        companion.ifPresent(beside -> beside.afterDrawing(this, scene));
    }

    private void updateDisplay() {
        window.swap();
        clock.awaitTurn();
        scene.paced(clock.pace());
    }

    /** Destroys the present window and opens the next one, if another scene was chosen. */
    private void change() {
        if (wanted != null && !isOver) {
            boolean fades = settings().motion() == Settings.Motion.FULL;
            if (window != null && fades) {
                fadeOut();
            }
            closeWindow();
            scene = wanted;
            wanted = null;
            window = new Window(scene, this, size, troubles, choice, vsync);
            if (fades) {
                curtain.drop();
            }
            clock.restart();
        }
    }

    private void fadeOut() {
        for (int frame = 1; frame <= Curtain.FRAMES; frame++) {
            window.render(settings().detail(), Curtain.fallen(frame));
            window.swap();
            clock.awaitTurn();
        }
    }

    private void closeWindow() {
        if (window != null) {
            scene.closed();
            window.destroy();
            window = null;
        }
    }
}
