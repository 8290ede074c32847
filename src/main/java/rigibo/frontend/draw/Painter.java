package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import rigibo.backend.geometry.Shape;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

/**
 * The canvas of one window. Made and freed with the window's context; a frame is begun, drawn on
 * and ended.
 */
public final class Painter implements Canvas {

    private final Program ground = new Program("ground");
    private final int nothing = glGenVertexArrays();
    private final BodyBatch bodies = new BodyBatch();
    private final Pen pen = new Pen();

    /** Begins a frame on a framebuffer of a size in pixels; the picture keeps its proportions. */
    public void begin(int framebufferWidth, int framebufferHeight) {
        Letterbox box = Letterbox.of(framebufferWidth, framebufferHeight);
        glViewport(0, 0, framebufferWidth, framebufferHeight);
        glClearColor(0.07f, 0.08f, 0.13f, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glViewport(box.x(), box.y(), box.width(), box.height());
        glDisable(GL_BLEND);
        ground.use();
        glBindVertexArray(nothing);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        pen.begin((float) box.width() / Scene.WIDTH);
    }

    /** Ends the frame; seconds since the start let faces blink. */
    public void end(double seconds) {
        bodies.flush(seconds);
        pen.end();
    }

    /** Frees what OpenGL and NanoVG hold. */
    public void free() {
        pen.free();
        bodies.free();
        ground.free();
        glDeleteVertexArrays(nothing);
    }

    @Override
    public void camera(Camera camera) {
        bodies.camera(camera);
    }

    @Override
    public void gaze(double worldX, double worldY) {
        bodies.gaze(worldX, worldY);
    }

    @Override
    public void body(Shape shape, double x, double y, double angle, Skin skin, Mood mood) {
        bodies.body(shape, x, y, angle, skin, mood);
    }

    @Override
    public void particle(double x, double y, double size, double angle, Color color) {
        bodies.particle(x, y, size, angle, color);
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, Color color) {
        pen.line(x1, y1, x2, y2, width, color);
    }

    @Override
    public void disc(double x, double y, double radius, Color color) {
        pen.disc(x, y, radius, color);
    }

    @Override
    public void ring(
            double x, double y, double radius, double width, double fraction, Color color) {
        pen.ring(x, y, radius, width, fraction, color);
    }

    @Override
    public void panel(double x, double y, double width, double height, double corner, Color color) {
        pen.panel(x, y, width, height, corner, color);
    }

    @Override
    public void frame(double x, double y, double width, double height, double corner, Color color) {
        pen.frame(x, y, width, height, corner, color);
    }

    @Override
    public void text(
            String words, double x, double y, double size, Font font, Align align, Color color) {
        pen.text(words, x, y, size, font, align, color);
    }

    @Override
    public double textWidth(String words, double size, Font font) {
        return pen.textWidth(words, size, font);
    }

    @Override
    public void graph(
            double[] values, int count, double x, double y, double w, double h, Color color) {
        pen.graph(values, count, x, y, w, h, color);
    }
}
