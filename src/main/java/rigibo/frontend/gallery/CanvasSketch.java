package rigibo.frontend.gallery;

import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Skin;

/** A sketch on the canvas, through a camera. */
final class CanvasSketch implements Sketch {

    private static final double LINE = 2.5;
    private static final double POINT = 4.5;

    private final Canvas canvas;
    private final Camera camera;
    private final double boldness;
    private String figure = "";

    /** A sketch whose lines and points are a number of times as bold as usual. */
    CanvasSketch(Canvas canvas, Camera camera, double boldness) {
        this.canvas = canvas;
        this.camera = camera;
        this.boldness = boldness;
    }

    /** The number shown beside the title; empty if there is none. */
    String figure() {
        return figure;
    }

    private static Color color(Tone tone) {
        return switch (tone) {
            case PLAIN -> Color.BRASS;
            case GOOD -> Color.GOOD;
            case BAD -> Color.BAD;
        };
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, Tone tone) {
        canvas.line(camera, x1, y1, x2, y2, boldness * LINE, color(tone));
    }

    @Override
    public void point(double x, double y, Tone tone) {
        canvas.disc(camera.screenX(x), camera.screenY(y), boldness * POINT, color(tone));
    }

    @Override
    public void shape(Shape shape, Placement at) {
        canvas.body(shape, at.x(), at.y(), at.angle(), Skin.BALL, Canvas.Mood.GHOST);
    }

    @Override
    public void count(String number) {
        figure = number;
    }
}
