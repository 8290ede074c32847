package rigibo.frontend.scene;

import rigibo.backend.geometry.Shape;

/**
 * A canvas in px of a {@link Layout#sheet}: plates that were made for a desk are large enough for a
 * hand on it. Bodies of the world stay as they are.
 */
public final class Enlarged implements Canvas {

    private final Canvas canvas;
    private final Layout whole;
    private final Layout sheet;

    /** A canvas over all of the window of another one. */
    public Enlarged(Canvas canvas) {
        this.canvas = canvas;
        whole = canvas.layout();
        sheet = whole.sheet();
    }

    /** Converts an x of the other canvas to one of this, px. */
    public double x(double outer) {
        return (outer - whole.left()) / whole.type();
    }

    /** Converts a y of the other canvas to one of this, px. */
    public double y(double outer) {
        return (outer - whole.top()) / whole.type();
    }

    /** Tells of controls on this canvas in px of the other one. */
    public Narrator telling(Narrator narrator) {
        return new EnlargedNarrator(this, narrator);
    }

    /** Converts an x of this canvas to one of the other, px. */
    public double outX(double x) {
        return whole.left() + whole.type() * x;
    }

    /** Converts a y of this canvas to one of the other, px. */
    public double outY(double y) {
        return whole.top() + whole.type() * y;
    }

    @Override
    public Layout layout() {
        return sheet;
    }

    @Override
    public void scenery(Scenery behind, double x, double y, double width, double height) {
        double type = whole.type();
        canvas.scenery(behind, outX(x), outY(y), type * width, type * height);
    }

    @Override
    public void camera(Camera camera) {
        canvas.camera(camera);
    }

    @Override
    public void gaze(double worldX, double worldY) {
        canvas.gaze(worldX, worldY);
    }

    @Override
    public void body(Shape shape, double x, double y, double angle, Skin skin, Mood mood) {
        canvas.body(shape, x, y, angle, skin, mood);
    }

    @Override
    public void particle(double x, double y, double size, double angle, Color color) {
        canvas.particle(x, y, size, angle, color);
    }

    @Override
    public void puff(double x, double y, double size, Color color) {
        canvas.puff(x, y, size, color);
    }

    @Override
    public void glow(double x, double y, double size, Color color) {
        canvas.glow(x, y, size, color);
    }

    @Override
    public void veil(double share) {
        canvas.veil(share);
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, Color color) {
        canvas.line(outX(x1), outY(y1), outX(x2), outY(y2), whole.type() * width, color);
    }

    @Override
    public void curve(double[] xy, int points, double width, Color color) {
        double[] out = new double[2 * points];
        for (int i = 0; i < points; i++) {
            out[2 * i] = outX(xy[2 * i]);
            out[2 * i + 1] = outY(xy[2 * i + 1]);
        }
        canvas.curve(out, points, whole.type() * width, color);
    }

    @Override
    public void disc(double x, double y, double radius, Color color) {
        canvas.disc(outX(x), outY(y), whole.type() * radius, color);
    }

    @Override
    public void ring(
            double x, double y, double radius, double width, double fraction, Color color) {
        canvas.ring(outX(x), outY(y), whole.type() * radius, whole.type() * width, fraction, color);
    }

    @Override
    public void panel(double x, double y, double width, double height, double corner, Color color) {
        canvas.panel(
                outX(x),
                outY(y),
                whole.type() * width,
                whole.type() * height,
                whole.type() * corner,
                color);
    }

    @Override
    public void frame(double x, double y, double width, double height, double corner, Color color) {
        canvas.frame(
                outX(x),
                outY(y),
                whole.type() * width,
                whole.type() * height,
                whole.type() * corner,
                color);
    }

    @Override
    public void text(
            String words, double x, double y, double size, Font font, Align align, Color color) {
        canvas.text(words, outX(x), outY(y), whole.type() * size, font, align, color);
    }

    @Override
    public double textWidth(String words, double size, Font font) {
        return canvas.textWidth(words, whole.type() * size, font) / whole.type();
    }

    @Override
    public void graph(
            double[] values, int count, double x, double y, double w, double h, Color color) {
        canvas.graph(values, count, outX(x), outY(y), whole.type() * w, whole.type() * h, color);
    }
}
