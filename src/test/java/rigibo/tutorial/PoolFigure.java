package rigibo.tutorial;

import rigibo.backend.DebugDraw;
import rigibo.backend.DebugDraw.Layer;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.docs.Arrow;
import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Spot;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/** A picture of pools, drawn over each other as often as wanted, in a window of the world. */
final class PoolFigure {

    private static final double WIDTH = 720; // px
    private static final int LETTERS = 15; // px
    private static final double RIM = 1.5; // px

    /** How much is drawn of a body: faint ones stand where it was before. */
    enum Ink {
        FAINT("#DCE9F2", "#9CC3DC"),
        PLAIN("#7FB8DA", Palette.BLUE),
        GOOD("#A9DCCB", Palette.GREEN);

        private final String fill;
        private final String rim;

        Ink(String fill, String rim) {
            this.fill = fill;
            this.rim = rim;
        }
    }

    private static final String GROUND = "#D8D4CC";
    private static final String GROUND_RIM = "#8A857A";

    private final Drawing drawing = new Drawing(WIDTH);
    private final double left;
    private final double top;
    private final double scale;

    /** A picture of a window of the world, m. */
    PoolFigure(double left, double bottom, double right, double top) {
        this.left = left;
        this.top = top;
        scale = WIDTH / (right - left);
        drawing.endAt((top - bottom) * scale);
    }

    String svg() {
        return drawing.svg();
    }

    private double screenX(double x) {
        return (x - left) * scale;
    }

    private double screenY(double y) {
        return (top - y) * scale;
    }

    private Spot spot(double x, double y) {
        return new Spot(screenX(x), screenY(y));
    }

    /** Draws all joints and bodies of a pool, those that move in the given ink. */
    void pool(Pool pool, Ink ink) {
        pool.draw(new Pen(ink, body -> true), Layer.JOINTS, Layer.SHAPES);
    }

    /** Draws one body of a pool. */
    void body(Pool pool, RigidBody one, Ink ink) {
        pool.draw(new Pen(ink, body -> body == one), Layer.SHAPES);
    }

    /** Draws some of the bodies; what stands still is grey, and a sensor is hollow. */
    private final class Pen implements DebugDraw {

        private final Ink ink;
        private final Predicate<RigidBody> isDrawn;

        Pen(Ink ink, Predicate<RigidBody> isDrawn) {
            this.ink = ink;
            this.isDrawn = isDrawn;
        }

        @Override
        public void outline(RigidBody body, double[] x, double[] y, int points, Look look) {
            if (!isDrawn.test(body)) {
                return;
            }
            List<Spot> corners = new ArrayList<>();
            for (int i = 0; i < points; i++) {
                corners.add(spot(x[i], y[i]));
            }
            switch (look) {
                case SENSOR, DISABLED -> hollow(corners);
                case FIXED -> drawing.polygon(corners, GROUND, RIM, GROUND_RIM);
                case DRIVEN, AWAKE, ASLEEP -> drawing.polygon(corners, ink.fill, RIM, ink.rim);
            }
        }

        @Override
        public void joint(Joint joint) {
            Spot from = spot(joint.xA(), joint.yA());
            Spot to = spot(joint.xB(), joint.yB());
            drawing.line(from.x(), from.y(), to.x(), to.y(), 2, ink.rim);
        }
    }

    private void hollow(List<Spot> corners) {
        for (int i = 0; i < corners.size(); i++) {
            Spot one = corners.get(i);
            Spot next = corners.get((i + 1) % corners.size());
            drawing.dashed(one.x(), one.y(), next.x(), next.y(), Palette.GREEN);
        }
    }

    /** Draws an arrow between two points of the world, m. */
    void arrow(double fromX, double fromY, double toX, double toY) {
        Arrow.draw(drawing, spot(fromX, fromY), spot(toX, toY), Palette.VERMILLION);
    }

    /** Draws a path of points, x and y in turn, m. */
    void path(List<double[]> points, Ink ink) {
        List<Spot> spots = points.stream().map(point -> spot(point[0], point[1])).toList();
        drawing.path(spots, ink == Ink.FAINT ? 1 : 2.5, ink.rim);
    }

    /** Writes words whose baseline begins at a point of the world, m. */
    void words(double x, double y, String words) {
        drawing.textOver(screenX(x), screenY(y), Anchor.START, LETTERS, Palette.INK, words);
    }
}
