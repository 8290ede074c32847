package rigibo.frontend.editor;

import rigibo.frontend.editor.draft.Course;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import tools.jackson.databind.JsonNode;

import java.util.List;

/** Draws how far an item acts: the stream of a fan, the pull of a magnet, a blast, a path. */
final class Reaches {

    private static final double WIDTH = 1.5;
    private static final double ARROW = 7;
    private static final double STOP = 4;

    /** Shares of a stream's reach at which its arrows stand. */
    private static final double[] ARROWS = {0.25, 0.5, 0.75, 1};

    private static final Color STREAM = Color.ICE.alpha(0.55);
    private static final Color PULL = Color.BRASS.alpha(0.55);
    private static final Color BLAST = Color.BAD.alpha(0.7);

    private final Canvas canvas;
    private final Camera camera;
    private final Item item;
    private final Point middle;

    private Reaches(Canvas canvas, Camera camera, Item item) {
        this.canvas = canvas;
        this.camera = camera;
        this.item = item;
        middle = item.toWorld(item.form().centre());
    }

    /** Draws the reach of an item that acts on other things, such as a fan. */
    static void draw(Canvas canvas, Camera camera, Item item) {
        Reaches reaches = new Reaches(canvas, camera, item);
        JsonNode node = item.node();
        if (node.path("fan").isObject()) {
            reaches.stream(node.path("fan"));
        }
        if (node.path("magnet").isObject()) {
            reaches.ring(node.path("magnet").path("reach").asDouble(0), PULL);
        }
        if (node.path("blast").isObject()) {
            double radius = node.path("blast").path("radius").asDouble(0);
            reaches.ring(radius, BLAST);
            reaches.ring(radius + node.path("blast").path("falloff").asDouble(0), BLAST);
        }
        reaches.path();
    }

    private void stream(JsonNode fan) {
        double degrees = item.degrees() + fan.path("angle").asDouble(90);
        Point along = new Point(fan.path("reach").asDouble(0), 0).turned(degrees);
        Point across = new Point(0, fan.path("width").asDouble(0) / 2).turned(degrees);
        line(middle.plus(across), middle.plus(across).plus(along), STREAM);
        line(middle.minus(across), middle.minus(across).plus(along), STREAM);
        double way = fan.path("force").asDouble(0) < 0 ? 180 : 0;
        for (double share : ARROWS) {
            arrow(middle.plus(along.times(share)), degrees + way);
        }
    }

    private void arrow(Point tip, double degrees) {
        double size = ARROW / camera.scale();
        line(tip, tip.plus(new Point(-size, size).turned(degrees)), STREAM);
        line(tip, tip.plus(new Point(-size, -size).turned(degrees)), STREAM);
    }

    private void ring(double metres, Color color) {
        double x = camera.screenX(middle.x());
        double y = camera.screenY(middle.y());
        canvas.ring(x, y, metres * camera.scale(), WIDTH, 1, color);
    }

    private void path() {
        List<Point> stops = new Course(item).stops();
        Point from = item.place();
        for (Point stop : stops) {
            line(from, stop, PULL);
            canvas.disc(camera.screenX(stop.x()), camera.screenY(stop.y()), STOP, Color.BRASS);
            from = stop;
        }
    }

    private void line(Point from, Point to, Color color) {
        canvas.line(camera, from.x(), from.y(), to.x(), to.y(), WIDTH, color);
    }
}
