package rigibo.lab.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

import javax.imageio.ImageIO;

/** A raster picture with two pixels per px, so that it is sharp on fine displays. */
public final class Png implements Picture {

    private static final double SCALE = 2;

    /** The width of the rim around letters, px. */
    private static final float RIM = 4;

    private static final float[] DASHES = {4, 4};

    private final PngLetters letters;
    private final BufferedImage image;
    private final Graphics2D pen;

    /** A white picture of a size in px. */
    public Png(PngLetters letters, double width, double height) {
        this.letters = letters;
        image =
                new BufferedImage(
                        (int) Math.ceil(width * SCALE),
                        (int) Math.ceil(height * SCALE),
                        BufferedImage.TYPE_INT_RGB);
        pen = image.createGraphics();
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        pen.scale(SCALE, SCALE);
        box(0, width, 0, height, Palette.PAPER);
    }

    /** Writes the file. */
    public void write(Path file) throws IOException {
        ImageIO.write(image, "png", file.toFile());
    }

    @Override
    public void text(double x, double y, Anchor anchor, int size, String color, String words) {
        fill(letters(x, y, anchor, size, words), color);
    }

    @Override
    public void textOver(double x, double y, Anchor anchor, int size, String color, String words) {
        Shape shape = letters(x, y, anchor, size, words);
        stroke(shape, RIM, Palette.PAPER);
        fill(shape, color);
    }

    private Shape letters(double x, double y, Anchor anchor, int size, String words) {
        double left = anchor.left(x, letters.width(words, size));
        return AffineTransform.getTranslateInstance(left, y)
                .createTransformedShape(letters.outline(words, size));
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, String color) {
        stroke(new Line2D.Double(x1, y1, x2, y2), width, color);
    }

    @Override
    public void dashed(double x1, double y1, double x2, double y2, String color) {
        pen.setColor(color(color));
        pen.setStroke(
                new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, DASHES, 0));
        pen.draw(new Line2D.Double(x1, y1, x2, y2));
    }

    @Override
    public void path(List<Spot> spots, double width, String color) {
        stroke(path(spots), width, color);
    }

    @Override
    public void box(double fromX, double toX, double y, double height, String color) {
        double left = Math.min(fromX, toX);
        fill(new Rectangle2D.Double(left, y, Math.abs(toX - fromX), height), color);
    }

    @Override
    public void dot(double x, double y, double radius, String color) {
        fill(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius), color);
    }

    @Override
    public void polygon(List<Spot> corners, String color, double rimWidth, String rim) {
        Path2D outline = path(corners);
        outline.closePath();
        fill(outline, color);
        stroke(outline, rimWidth, rim);
    }

    private static Path2D path(List<Spot> spots) {
        Path2D path = new Path2D.Double();
        path.moveTo(spots.get(0).x(), spots.get(0).y());
        spots.forEach(spot -> path.lineTo(spot.x(), spot.y()));
        return path;
    }

    private void fill(Shape shape, String color) {
        pen.setColor(color(color));
        pen.fill(shape);
    }

    private void stroke(Shape shape, double width, String color) {
        pen.setColor(color(color));
        pen.setStroke(new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND));
        pen.draw(shape);
    }

    private static Color color(String color) {
        return new Color(Palette.rgb(color));
    }
}
