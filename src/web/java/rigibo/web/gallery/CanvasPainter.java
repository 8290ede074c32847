package rigibo.web.gallery;

import org.teavm.jso.canvas.CanvasRenderingContext2D;
import org.teavm.jso.dom.html.HTMLCanvasElement;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Draws a pool on a canvas, as many pixels wide and high as it is shown, and the sketch above. */
final class CanvasPainter implements Sketch {

    private static final String EDGE = "#12152a";
    private static final String STILL = "#6c7486";
    private static final String DRIVEN = "#4f9fbd";
    private static final String MOVING = "#e8a04c";
    private static final String ASLEEP = "#a8743a";
    private static final String GLASS = "rgba(244,241,230,0.35)";
    private static final String TEXT = "#f4f1e6";

    private final HTMLCanvasElement canvas;
    private final CanvasRenderingContext2D pen;
    private final double ratio = org.teavm.jso.browser.Window.current().getDevicePixelRatio();
    private double scale;
    private double left;
    private double top;
    private String figure = "";

    CanvasPainter(HTMLCanvasElement canvas) {
        this.canvas = canvas;
        pen = (CanvasRenderingContext2D) canvas.getContext("2d");
    }

    /** The number that the sketch is about, empty where there is none. */
    String figure() {
        return figure;
    }

    void paint(Running running) {
        fit(running.exhibit.view());
        pen.clearRect(0, 0, canvas.getWidth(), canvas.getHeight());
        pen.setLineJoin("round");
        for (RigidBody body : running.pool.bodies()) {
            draw(body);
        }
        running.exhibit.sketch(running.pool, this);
    }

    /** The view is as high as it says, or as wide, in a canvas that is higher than wide. */
    private void fit(View view) {
        int width = (int) (ratio * canvas.getClientWidth());
        int height = (int) (ratio * canvas.getClientHeight());
        if (canvas.getWidth() != width || canvas.getHeight() != height) {
            canvas.setWidth(width);
            canvas.setHeight(height);
        }
        scale = Math.min(width, height) / view.height();
        left = view.x() - width / scale / 2;
        top = view.y() + height / scale / 2;
    }

    private double screenX(double x) {
        return (x - left) * scale;
    }

    private double screenY(double y) {
        return (top - y) * scale;
    }

    private void draw(RigidBody body) {
        Shape shape = body.shape();
        double cos = Math.cos(body.angle());
        double sin = Math.sin(body.angle());
        pen.setStrokeStyle(EDGE);
        pen.setLineWidth(ratio);
        for (int part = 0; part < shape.parts(); part++) {
            Outline outline = shape.outline(part);
            pen.setFillStyle(shape.isSensor(part) ? GLASS : color(body));
            trace(outline, body.x(), body.y(), cos, sin);
            pen.fill();
            pen.stroke();
            if (outline.isDisc()) {
                spoke(outline, body.x(), body.y(), cos, sin);
            }
        }
    }

    private static String color(RigidBody body) {
        if (body.type() != BodyType.DYNAMIC) {
            return body.type() == BodyType.STATIC ? STILL : DRIVEN;
        }
        return body.isAwake() ? MOVING : ASLEEP;
    }

    /** An arc about each corner joins its edges; of a sharp one it is a point. */
    private void trace(Outline outline, double x, double y, double cos, double sin) {
        pen.beginPath();
        int count = outline.corners();
        double radius = scale * outline.radius();
        for (int i = 0; i < count; i++) {
            double atX = screenX(x + cos * outline.cornerX(i) - sin * outline.cornerY(i));
            double atY = screenY(y + sin * outline.cornerX(i) + cos * outline.cornerY(i));
            if (outline.isDisc()) {
                pen.arc(atX, atY, radius, 0, 2 * Math.PI);
            } else if (radius > 0) {
                int before = (i + count - 1) % count;
                double turned = Math.atan2(sin, cos);
                double from = Math.atan2(outline.normalY(before), outline.normalX(before));
                double to = Math.atan2(outline.normalY(i), outline.normalX(i));
                pen.arc(atX, atY, radius, -from - turned, -to - turned, true);
            } else {
                pen.lineTo(atX, atY);
            }
        }
        pen.closePath();
    }

    /** By which a disc is seen to turn. */
    private void spoke(Outline disc, double x, double y, double cos, double sin) {
        double fromX = x + cos * disc.cornerX(0) - sin * disc.cornerY(0);
        double fromY = y + sin * disc.cornerX(0) + cos * disc.cornerY(0);
        stroke(fromX, fromY, fromX + cos * disc.radius(), fromY + sin * disc.radius());
    }

    private void stroke(double x1, double y1, double x2, double y2) {
        pen.beginPath();
        pen.moveTo(screenX(x1), screenY(y1));
        pen.lineTo(screenX(x2), screenY(y2));
        pen.stroke();
    }

    private static String color(Tone tone) {
        return switch (tone) {
            case PLAIN -> "#d9b36c";
            case GOOD -> "#3fc1a9";
            case BAD -> "#f2685e";
        };
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, Tone tone) {
        pen.setStrokeStyle(color(tone));
        pen.setLineWidth(2.5 * ratio);
        stroke(x1, y1, x2, y2);
    }

    @Override
    public void point(double x, double y, Tone tone) {
        pen.setFillStyle(color(tone));
        pen.beginPath();
        pen.arc(screenX(x), screenY(y), 4.5 * ratio, 0, 2 * Math.PI);
        pen.fill();
    }

    @Override
    public void shape(Shape shape, Placement at) {
        pen.setFillStyle(GLASS);
        for (int part = 0; part < shape.parts(); part++) {
            double angle = at.angle();
            trace(shape.outline(part), at.x(), at.y(), Math.cos(angle), Math.sin(angle));
            pen.fill();
        }
    }

    @Override
    public void number(double x, double y, String number) {
        pen.setFillStyle(TEXT);
        pen.setFont(18 * ratio + "px monospace");
        pen.setTextAlign("center");
        pen.fillText(number, screenX(x), screenY(y));
    }

    @Override
    public void count(String number) {
        figure = number;
    }
}
