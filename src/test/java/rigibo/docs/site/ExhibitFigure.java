package rigibo.docs.site;

import rigibo.backend.DebugDraw;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Looks;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;
import rigibo.frontend.scene.Color;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.Spot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A picture of an exhibit, in the colours that the game gives it. */
final class ExhibitFigure implements DebugDraw, Sketch {

    private static final double WIDTH = 480; // px
    private static final double HEIGHT = 360; // px

    /** Share of the picture's height that shows what a window of the game shows. */
    private static final double FILLED = 1.1;

    private static final double RIM = 0.8; // px
    private static final double LINE = 2; // px
    private static final double POINT = 3.5; // px

    /** Corners of what is drawn in place of a disc. */
    private static final int AROUND = 40;

    /** Share of a body's colour that its rim keeps, and share that a sleeping body keeps. */
    private static final double RIM_SHADE = 0.55;

    private static final double ASLEEP_SHADE = 0.75;

    private final Drawing drawing = new Drawing(WIDTH);
    private final View view;
    private final double scale;

    private ExhibitFigure(View view) {
        this.view = view;
        scale = FILLED * HEIGHT / view.height();
        drawing.endAt(HEIGHT);
        drawing.box(0, WIDTH, 0, HEIGHT, hex(Color.DUSK_TOP, 1));
    }

    /** The SVG of an exhibit after so many seconds. */
    static String svg(Exhibit exhibit, double seconds) {
        ExhibitFigure figure = new ExhibitFigure(exhibit.view());
        try (Pool pool = exhibit.open()) {
            exhibit.run(pool, seconds);
            pool.draw(figure, Layer.SHAPES, Layer.JOINTS);
            exhibit.sketch(pool, figure);
        }
        return figure.drawing.svg();
    }

    private static String hex(Color color, double shade) {
        return String.format(
                Locale.ROOT,
                "#%02X%02X%02X",
                Math.round(255 * shade * color.red()),
                Math.round(255 * shade * color.green()),
                Math.round(255 * shade * color.blue()));
    }

    private Spot spot(double x, double y) {
        return new Spot(WIDTH / 2 + (x - view.x()) * scale, HEIGHT / 2 - (y - view.y()) * scale);
    }

    @Override
    public void outline(RigidBody body, double[] x, double[] y, int points, Look look) {
        List<Spot> corners = new ArrayList<>();
        for (int i = 0; i < points; i++) {
            corners.add(spot(x[i], y[i]));
        }
        Color color = Looks.of(body).color;
        switch (look) {
            case SENSOR, DISABLED -> hollow(corners, hex(Color.GOOD, 1));
            case FIXED, DRIVEN, AWAKE -> fill(corners, color, 1);
            case ASLEEP -> fill(corners, color, ASLEEP_SHADE);
        }
    }

    /** An edge of a chain has nothing within. */
    private void fill(List<Spot> corners, Color color, double shade) {
        if (corners.size() == 2) {
            drawing.path(corners, LINE, hex(color, shade));
            return;
        }
        drawing.polygon(corners, hex(color, shade), RIM, hex(color, RIM_SHADE * shade));
    }

    private void hollow(List<Spot> corners, String color) {
        List<Spot> closed = new ArrayList<>(corners);
        closed.add(corners.get(0));
        drawing.path(closed, RIM, color);
    }

    @Override
    public void joint(Joint joint) {
        Spot from = spot(joint.xA(), joint.yA());
        Spot to = spot(joint.xB(), joint.yB());
        drawing.path(List.of(from, to), LINE, hex(Color.BRASS, 1));
        drawing.dot(from.x(), from.y(), LINE, hex(Color.BRASS, 1));
        drawing.dot(to.x(), to.y(), LINE, hex(Color.BRASS, 1));
    }

    private static String color(Tone tone) {
        return hex(
                switch (tone) {
                    case PLAIN -> Color.BRASS;
                    case GOOD -> Color.GOOD;
                    case BAD -> Color.BAD;
                },
                1);
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, Tone tone) {
        drawing.path(List.of(spot(x1, y1), spot(x2, y2)), LINE, color(tone));
    }

    @Override
    public void point(double x, double y, Tone tone) {
        Spot at = spot(x, y);
        drawing.dot(at.x(), at.y(), POINT, color(tone));
    }

    @Override
    public void shape(Shape shape, Placement at) {
        for (int part = 0; part < shape.parts(); part++) {
            hollow(corners(shape.outline(part), at), hex(Color.BALL, 1));
        }
    }

    /** Those of a polygon; around a disc, many. */
    private List<Spot> corners(Outline outline, Placement at) {
        double cos = Math.cos(at.angle());
        double sin = Math.sin(at.angle());
        boolean isDisc = outline.corners() == 1;
        int count = isDisc ? AROUND : outline.corners();
        List<Spot> corners = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double around = isDisc ? 2 * Math.PI * i / AROUND : 0;
            double reach = isDisc ? outline.radius() : 0;
            double x = outline.cornerX(isDisc ? 0 : i) + reach * Math.cos(around);
            double y = outline.cornerY(isDisc ? 0 : i) + reach * Math.sin(around);
            corners.add(spot(at.x() + cos * x - sin * y, at.y() + sin * x + cos * y));
        }
        return corners;
    }

    /** The pages have their own words. */
    @Override
    public void count(String figure) {}
}
