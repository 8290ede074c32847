package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;
import static org.lwjgl.opengl.GL33C.*;

import org.lwjgl.glfw.Callbacks;
import org.lwjgl.glfw.GLFWDropCallback;
import org.lwjgl.glfw.GLFWVidMode;
import org.lwjgl.opengl.GL;
import org.lwjgl.stb.STBImageWrite;
import org.lwjgl.system.MemoryUtil;
import org.tinylog.Logger;

import rigibo.frontend.draw.DetailChoice;
import rigibo.frontend.draw.Painter;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Edges;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Pane;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.widget.Plate;

import java.nio.ByteBuffer;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** One window with its OpenGL context, its painter and its input, for one scene. */
final class Window {

    private static final int BYTES_PER_PIXEL = 3;

    private final Scene scene;
    private final Input input;
    private final Toast toast;
    private final Supplier<Settings.TextSize> text;
    private final WindowSize size;
    private final Troubles troubles;
    private final long handle;
    private final Painter painter;
    private final DetailChoice choice;
    private final int[] width = new int[1];
    private final int[] height = new int[1];
    private Layout layout;
    private Plate wayBack = Plate.NONE;
    private boolean isFull;

    /** Darkness from which on a picture can be made out, 0 to 1. */
    private static final double DUSK = 0.5;

    /** Whether a picture was shown; input that came before cannot be meant for the scene. */
    private boolean isSeen;

    /** Darkness of the picture that was drawn last. */
    private double darkness = 1;

    /**
     * Opens a window.
     *
     * @throws DisplayException when there is no window or no OpenGL 3.3 to be had
     */
    Window(
            Scene scene,
            Display display,
            WindowSize size,
            Troubles troubles,
            DetailChoice choice,
            boolean vsync) {
        this.scene = scene;
        this.size = size;
        toast = display.toast();
        text = () -> display.settings().text();
        this.troubles = troubles;
        this.choice = choice;
        handle = GlWindow.create(scene.title(), troubles);
        size.open(handle);
        glfwMakeContextCurrent(handle);
        GL.createCapabilities();
        glfwSwapInterval(vsync ? 1 : 0);
        choice.renderer(glGetString(GL_RENDERER));
        painter = new Painter();
        input =
                new Input(
                        scene,
                        this::close,
                        display::toggleFullScreen,
                        display::toggleMute,
                        display::paste,
                        () -> display.settings().keys());
        listen();
        listenToDrops(display::dropped);
        fill(display.settings().isFullScreen());
        tryDetail(display.settings().detail());
        glfwShowWindow(handle);
    }

    /** Draws pictures that are not shown, to find out how long one takes. */
    private void tryDetail(Settings.Detail chosen) {
        while (choice.isOpen(chosen)) {
            choice.tried(draw(chosen, 0));
        }
    }

    private void listen() {
        glfwSetCursorPosCallback(handle, (window, x, y) -> input.cursor(x, y));
        glfwSetMouseButtonCallback(
                handle,
                (window, button, action, mods) -> {
                    if (isSeen) {
                        input.modifiers(mods);
                        input.mouseButton(button, action);
                    }
                });
        glfwSetScrollCallback(
                handle,
                (window, dx, dy) -> {
                    if (isSeen) {
                        input.scroll(dy);
                    }
                });
        glfwSetKeyCallback(
                handle,
                (window, key, code, action, mods) -> {
                    if (isSeen) {
                        input.modifiers(mods, key, action);
                        input.key(asLabelled(key, code), action);
                    }
                });
        glfwSetCharCallback(
                handle,
                (window, codePoint) -> {
                    if (isSeen) {
                        input.character(codePoint);
                    }
                });
        glfwSetWindowSizeCallback(handle, (window, w, h) -> layOut());
        layOut();
    }

    /** Updates the layout, so that the next press hits what the player saw at that place. */
    private void layOut() {
        glfwGetWindowSize(handle, width, height);
        int units = Math.max(1, width[0]);
        glfwGetFramebufferSize(handle, width, height);
        float[] contentScale = new float[1];
        glfwGetWindowContentScale(handle, contentScale, new float[1]);
        Pane pane = new Pane(width[0], height[0], contentScale[0], Edges.NONE, false);
        layout = pane.layout(scene, text.get().share());
        wayBack = WayBack.place(pane, layout, scene);
        input.shows(layout, width[0] / (double) units, wayBack);
    }

    private void listenToDrops(Consumer<List<Path>> dropped) {
        glfwSetDropCallback(
                handle,
                (window, count, names) -> {
                    List<Path> files = new ArrayList<>();
                    for (int i = 0; i < count; i++) {
                        file(GLFWDropCallback.getName(names, i)).ifPresent(files::add);
                    }
                    if (!files.isEmpty()) {
                        dropped.accept(files);
                    }
                });
    }

    /** In a locale without umlauts, Java cannot name a file that has one. */
    private static Optional<Path> file(String name) {
        try {
            return Optional.of(Path.of(name));
        } catch (InvalidPathException unnamable) {
            Logger.warn("A file is not opened: {}", unnamable.getMessage());
            return Optional.empty();
        }
    }

    /**
     * Translates a letter key to the letter printed on it, since keyboard layouts exchange Z and Y.
     */
    private static int asLabelled(int key, int code) {
        String label = key >= GLFW_KEY_A && key <= GLFW_KEY_Z ? glfwGetKeyName(key, code) : null;
        boolean isLetter = label != null && label.matches("[a-z]");
        return isLetter ? GLFW_KEY_A + label.charAt(0) - 'a' : key;
    }

    /** Handles a gamepad's button, as a key is handled. */
    void gamepad(GamepadButton button) {
        if (isSeen) {
            input.gamepad(button);
        }
    }

    Input input() {
        return input;
    }

    void copy(String text) {
        glfwSetClipboardString(handle, text);
    }

    /** The text on the clipboard, empty if there is none. */
    String pasted() {
        String text = glfwGetClipboardString(handle);
        return text == null ? "" : text;
    }

    boolean wantsToClose() {
        return glfwWindowShouldClose(handle);
    }

    void close() {
        glfwSetWindowShouldClose(handle, true);
    }

    /**
     * Draws the scene into the back buffer and waits for OpenGL: nothing else is to be done until
     * the frame is shown, and only then is its cost known.
     *
     * @param chosen how much the player wants to be drawn
     * @param dark from 0, not at all, to 1, black
     */
    void render(Settings.Detail chosen, double dark) {
        scene.drawn(draw(chosen, dark));
        troubles.askOpenGl("while drawing " + scene.title());
    }

    /** Draws a picture; returns the time it took, ns. */
    private long draw(Settings.Detail chosen, double dark) {
        long begin = System.nanoTime();
        layOut();
        painter.begin(layout, scene.scenery(), glfwGetTime(), choice.detail(chosen));
        scene.draw(painter);
        WayBack.draw(painter, wayBack);
        toast.draw(painter);
        painter.end(dark);
        darkness = dark;
        glFinish();
        return System.nanoTime() - begin;
    }

    /** Resizes the window as the player would by dragging its edge; in screen coordinates. */
    void resize(int newWidth, int newHeight) {
        glfwSetWindowSize(handle, newWidth, newHeight);
    }

    /** Takes the focus away and gives it back, as if the player had switched windows. */
    void hideAndShow() {
        glfwHideWindow(handle);
        glfwShowWindow(handle);
    }

    /** Shows the frame that was drawn. */
    void swap() {
        glfwSwapBuffers(handle);
        isSeen = isSeen || darkness < DUSK;
    }

    /** Writes the frame that was drawn, but not yet shown, to a PNG file. */
    void picture(Path file) {
        glfwGetFramebufferSize(handle, width, height);
        int row = width[0] * BYTES_PER_PIXEL;
        ByteBuffer pixels = MemoryUtil.memAlloc(row * height[0]);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width[0], height[0], GL_RGB, GL_UNSIGNED_BYTE, pixels);
        STBImageWrite.stbi_flip_vertically_on_write(true);
        boolean written =
                STBImageWrite.stbi_write_png(
                        file.toString(), width[0], height[0], BYTES_PER_PIXEL, pixels, row);
        MemoryUtil.memFree(pixels);
        if (!written) {
            throw new DisplayException("cannot write the picture " + file);
        }
    }

    /** Frees everything: GL and NanoVG objects, callbacks, context, window, in this order. */
    void destroy() {
        size.keep(handle);
        painter.free();
        Callbacks.glfwFreeCallbacks(handle);
        glfwMakeContextCurrent(0);
        GL.setCapabilities(null);
        glfwDestroyWindow(handle);
    }

    /** Switches full screen on or off; without a monitor the window stays as it is. */
    void fill(boolean wanted) {
        long monitor = glfwGetPrimaryMonitor();
        GLFWVidMode mode = monitor == 0 ? null : glfwGetVideoMode(monitor);
        if (mode == null || wanted == isFull) {
            return;
        }
        isFull = wanted;
        if (isFull) {
            size.keep(handle);
            glfwSetWindowMonitor(
                    handle, monitor, 0, 0, mode.width(), mode.height(), mode.refreshRate());
        } else {
            size.restore(handle);
        }
    }
}
