package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;
import static org.lwjgl.opengl.GL33C.*;

import org.lwjgl.opengl.GL;
import org.lwjgl.system.MemoryUtil;

import rigibo.frontend.draw.Detail;
import rigibo.frontend.draw.Painter;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;

import java.nio.ByteBuffer;
import java.util.List;

/**
 * Draws scenes without showing them. They are drawn into a framebuffer of our own, because the
 * content of a hidden window is undefined.
 */
public final class Offscreen implements AutoCloseable {

    private static final int BYTES_PER_PIXEL = 4;

    private final int width;
    private final int height;
    private final Troubles troubles = new Troubles();
    private final long window;
    private final Painter painter;
    private final int colors;
    private final int stencil;
    private final int frame;
    private final ByteBuffer pixels;
    private boolean isBaked;

    /**
     * Makes pictures of a size in px.
     *
     * @throws DisplayException when there is no OpenGL 3.3 to be had, or no display
     */
    public Offscreen(int width, int height) {
        this.width = width;
        this.height = height;
        troubles.listen();
        if (!glfwInit()) {
            throw new DisplayException("RigiBo cannot draw: " + troubles.last());
        }
        window = GlWindow.create("RigiBo", troubles);
        glfwMakeContextCurrent(window);
        GL.createCapabilities();
        painter = new Painter();
        colors = buffer(GL_RGBA8);
        stencil = buffer(GL_DEPTH24_STENCIL8);
        frame = glGenFramebuffers();
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colors);
        glFramebufferRenderbuffer(
                GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, stencil);
        pixels = MemoryUtil.memAlloc(BYTES_PER_PIXEL * width * height);
    }

    private int buffer(int format) {
        int buffer = glGenRenderbuffers();
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
        return buffer;
    }

    /** Width in px. */
    public int width() {
        return width;
    }

    /** Height of the pictures in px. */
    public int height() {
        return height;
    }

    /**
     * Draws the present state of a scene.
     *
     * @param seconds since it began, for motion outside the physics, such as blinking eyes
     * @return its colours 0xRRGGBB, row by row from the top
     */
    public int[] picture(Scene scene, double seconds) {
        if (!isBaked) {
            // Textures that are computed once leave the window's own framebuffer bound afterwards.
            draw(scene, seconds);
            isBaked = true;
        }
        draw(scene, seconds);
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        troubles.askOpenGl("while drawing " + scene.title());
        int[] picture = new int[width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                picture[y * width + x] = color(BYTES_PER_PIXEL * ((height - 1 - y) * width + x));
            }
        }
        return picture;
    }

    private int color(int at) {
        return (pixels.get(at) & 0xff) << 16
                | (pixels.get(at + 1) & 0xff) << 8
                | pixels.get(at + 2) & 0xff;
    }

    private void draw(Scene scene, double seconds) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        painter.begin(Layout.of(width, height, 1), scene.scenery(), seconds, Detail.FULL);
        scene.draw(painter);
        painter.end(0);
        glFinish();
    }

    /** Complaints of GLFW and OpenGL. */
    public List<String> troubles() {
        return troubles.all();
    }

    @Override
    public void close() {
        MemoryUtil.memFree(pixels);
        glDeleteFramebuffers(frame);
        glDeleteRenderbuffers(colors);
        glDeleteRenderbuffers(stencil);
        painter.free();
        glfwMakeContextCurrent(0);
        GL.setCapabilities(null);
        glfwDestroyWindow(window);
        glfwTerminate();
    }
}
