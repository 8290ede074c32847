package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import rigibo.backend.geometry.Shape;
import rigibo.frontend.draw.ParticleBatch.Kind;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scenery;
import rigibo.frontend.scene.Skin;

/**
 * The canvas of one window. It is made and freed with the window's context; a frame is begun, drawn
 * on and ended. Plates and pen drawings are collected separately, and the pen's lie above. A plate
 * that must cover pen drawings first has everything collected so far drawn.
 */
public final class Painter implements Canvas {

    private final BodyBatch bodies = new BodyBatch();
    private final Plates plates = new Plates();
    private final Pen pen = new Pen();
    private final Marks marks = new Marks();
    private final Backdrops backdrops = new Backdrops();
    private Detail detail;
    private Layout layout = Layout.ALONE;

    /**
     * Begins a frame that fills a framebuffer with what a layout for its size in pixels shows,
     * before a scenery. Seconds since the start let faces blink.
     */
    public void begin(Layout wanted, Scenery behind, double seconds, Detail most) {
        bodies.begin(seconds, most);
        if (!wanted.equals(layout) || most != detail) {
            layout = wanted;
            detail = most;
            backdrops.free();
        }
        lay(behind, layout, 0, 0);
        pen.begin(layout);
    }

    /** Lays a scenery as a window shows it onto the framebuffer, with a corner at a pixel. */
    private void lay(Scenery scenery, Layout window, int left, int bottom) {
        Baked backdrop = backdrops.of(scenery, window, detail);
        glViewport(0, 0, pixels(layout.width()), pixels(layout.height()));
        backdrop.copy(left, bottom);
    }

    private int pixels(double logical) {
        return (int) Math.round(logical * layout.ratio());
    }

    @Override
    public Layout layout() {
        return layout;
    }

    /** Ends the frame, darkened by a share from 0, not at all, to 1, black. */
    public void end(double darkness) {
        flush();
        if (darkness > 0) {
            cover(Color.NIGHT.alpha(darkness));
            plates.draw(layout);
        }
    }

    private void flush() {
        bodies.draw(layout);
        plates.draw(layout);
        pen.end();
        marks.clear();
    }

    /** Frees what OpenGL and NanoVG hold. */
    public void free() {
        pen.free();
        plates.free();
        bodies.free();
        backdrops.free();
    }

    @Override
    public void scenery(Scenery behind, double x, double y, double width, double height) {
        Layout window = Layout.of(pixels(width), pixels(height), 1);
        lay(behind, window, pixels(x - layout.left()), pixels(layout.bottom() - y - height));
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
        bodies.particle(Kind.SPLINTER, x, y, size, angle, color);
    }

    @Override
    public void puff(double x, double y, double size, Color color) {
        bodies.particle(Kind.PUFF, x, y, size, 0, color);
    }

    @Override
    public void glow(double x, double y, double size, Color color) {
        bodies.particle(Kind.GLOW, x, y, size, 0, color);
    }

    @Override
    public void veil(double share) {
        bodies.veil(share);
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, Color color) {
        marks.add(Math.min(x1, x2), Math.min(y1, y2), Math.max(x1, x2), Math.max(y1, y2));
        pen.line(x1, y1, x2, y2, width, color);
    }

    @Override
    public void curve(double[] xy, int points, double width, Color color) {
        for (int i = 1; i < points; i++) {
            double left = Math.min(xy[2 * i - 2], xy[2 * i]);
            double top = Math.min(xy[2 * i - 1], xy[2 * i + 1]);
            double right = Math.max(xy[2 * i - 2], xy[2 * i]);
            double bottom = Math.max(xy[2 * i - 1], xy[2 * i + 1]);
            marks.add(left, top, right, bottom);
        }
        pen.curve(xy, points, width, color);
    }

    @Override
    public void disc(double x, double y, double radius, Color color) {
        marks.add(x - radius, y - radius, x + radius, y + radius);
        pen.disc(x, y, radius, color);
    }

    @Override
    public void ring(
            double x, double y, double radius, double width, double fraction, Color color) {
        marks.add(x - radius, y - radius, x + radius, y + radius);
        pen.ring(x, y, radius, width, fraction, color);
    }

    @Override
    public void panel(double x, double y, double width, double height, double corner, Color color) {
        if (marks.meet(x, y, x + width, y + height)) {
            flush();
            pen.begin(layout);
        }
        plates.add(x, y, width, height, corner, color);
    }

    @Override
    public void frame(double x, double y, double width, double height, double corner, Color color) {
        marks.add(x, y, x + width, y + 1);
        marks.add(x, y + height - 1, x + width, y + height);
        marks.add(x, y, x + 1, y + height);
        marks.add(x + width - 1, y, x + width, y + height);
        pen.frame(x, y, width, height, corner, color);
    }

    @Override
    public void text(
            String words, double x, double y, double size, Font font, Align align, Color color) {
        double width = textWidth(words, size, font);
        double left =
                switch (align) {
                    case LEFT -> x;
                    case CENTRE -> x - width / 2;
                    case RIGHT -> x - width;
                };
        double drawn = layout.textSize(size);
        marks.add(left, y - drawn / 2, left + width, y + drawn / 2);
        pen.text(words, x, y, drawn, font, align, color);
    }

    @Override
    public double textWidth(String words, double size, Font font) {
        return pen.textWidth(words, layout.textSize(size), font);
    }

    @Override
    public void graph(
            double[] values, int count, double x, double y, double w, double h, Color color) {
        marks.add(x, y, x + w, y + h);
        pen.graph(values, count, x, y, w, h, color);
    }
}
