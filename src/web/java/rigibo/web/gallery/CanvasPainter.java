package rigibo.web.gallery;

import org.teavm.jso.canvas.CanvasRenderingContext2D;
import org.teavm.jso.dom.html.HTMLCanvasElement;

import rigibo.backend.DebugDraw;
import rigibo.backend.Joint;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Draws a pool on a canvas, as many pixels wide and high as it is shown, and the sketch above. */
final class CanvasPainter implements Sketch, DebugDraw {

    private static final String EDGE = "#12152a";
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
        running.pool.draw(this, Layer.SHAPES, Layer.JOINTS);
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

    @Override
    public void outline(RigidBody body, double[] x, double[] y, int points, Look look) {
        pen.beginPath();
        for (int i = 0; i < points; i++) {
            pen.lineTo(screenX(x[i]), screenY(y[i]));
        }
        pen.closePath();
        pen.setFillStyle(color(look));
        pen.fill();
        // An edge of a chain has no inside that could show it.
        pen.setStrokeStyle(points > 2 ? EDGE : color(look));
        pen.setLineWidth(points > 2 ? ratio : 2.5 * ratio);
        pen.stroke();
        if (body.shape() instanceof Circle) {
            stroke(body.x(), body.y(), x[0], y[0]);
        }
    }

    private static String color(Look look) {
        return switch (look) {
            case FIXED -> "#6c7486";
            case DRIVEN -> "#4f9fbd";
            case AWAKE -> "#e8a04c";
            case ASLEEP -> "#a8743a";
            case SENSOR, DISABLED -> GLASS;
        };
    }

    /** A pin where the two anchors are one, else a line between two pins. */
    @Override
    public void joint(Joint joint) {
        pen.setStrokeStyle(TEXT);
        pen.setLineWidth(1.5 * ratio);
        stroke(joint.xA(), joint.yA(), joint.xB(), joint.yB());
        dot(joint.xA(), joint.yA(), 2.5, TEXT);
        dot(joint.xB(), joint.yB(), 2.5, TEXT);
    }

    private void dot(double x, double y, double radius, String color) {
        pen.setFillStyle(color);
        pen.beginPath();
        pen.arc(screenX(x), screenY(y), radius * ratio, 0, 2 * Math.PI);
        pen.fill();
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
        dot(x, y, 4.5, color(tone));
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
