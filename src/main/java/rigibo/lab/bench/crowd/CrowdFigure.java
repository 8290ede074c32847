package rigibo.lab.bench.crowd;

import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.Label;
import rigibo.lab.plot.LabelPlacer;
import rigibo.lab.plot.LogScale;
import rigibo.lab.plot.Mark;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Plot;
import rigibo.lab.plot.Spot;
import rigibo.lab.report.Amount;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A figure of the time of a step over the number of bodies, with a line at 60 steps per second. */
public final class CrowdFigure {

    private static final int TITLE = 18;
    private static final int WORDS = 14;
    private static final double LEFT = 76;
    private static final double RIGHT = 20;
    private static final double HEIGHT = 380;
    private static final double LINE_WIDTH = 2.2;
    private static final double RADIUS = 5;
    private static final double LABEL_GAP = 9;
    private static final double LABEL_REACH = 90;

    /** A step of the game, ms. */
    private static final double FRAME = 1000.0 / 60;

    private static final double NANOS_PER_MILLI = 1e6;
    private static final String[] COLORS = {
        Palette.INK, Palette.VERMILLION, Palette.PURPLE, Palette.BLUE
    };
    private static final Mark[] MARKS = {Mark.DISC, Mark.UP, Mark.SQUARE, Mark.DIAMOND};

    private final List<CrowdPoint> points;
    private final List<String> engines;

    /** A figure with the given points. */
    public CrowdFigure(List<CrowdPoint> points) {
        this.points = points;
        engines = points.stream().map(CrowdPoint::engine).distinct().toList();
    }

    /** Draws the figure with a width in px. */
    public Drawing drawing(double width) {
        Drawing drawing = new Drawing(width);
        double y = TITLE + 8;
        drawing.text(10, y, Anchor.START, TITLE, Palette.INK, "How many discs hold 60 Hz");
        y += 24;
        drawing.text(
                10, y, Anchor.START, WORDS, Palette.DIM, "↑ time of a step, median, one thread");
        double top = y + 14;
        double bottom = top + HEIGHT;
        Plot plot = new Plot(drawing, across(width), up(bottom, top));
        plot.grid(CrowdFigure::count, tick -> Amount.time(tick * NANOS_PER_MILLI));
        LabelPlacer placer = new LabelPlacer(plot.box());
        frame(drawing, plot, placer);
        for (int i = 0; i < engines.size(); i++) {
            line(drawing, plot, placer, i);
        }
        for (int i = 0; i < engines.size(); i++) {
            label(drawing, plot, placer, i);
        }
        drawing.text(
                width - RIGHT, bottom + 40, Anchor.END, WORDS, Palette.DIM, "discs in a trough →");
        drawing.endAt(bottom + 54);
        return drawing;
    }

    private LogScale across(double width) {
        double least = points.stream().mapToDouble(CrowdPoint::bodies).min().orElseThrow();
        double most = points.stream().mapToDouble(CrowdPoint::bodies).max().orElseThrow();
        return new LogScale(least / 1.3, most * 1.6, LEFT, width - RIGHT);
    }

    private LogScale up(double bottom, double top) {
        double least = points.stream().mapToDouble(CrowdPoint::median).min().orElseThrow();
        double most = points.stream().mapToDouble(CrowdPoint::median).max().orElseThrow();
        return new LogScale(least / 1.5, 1.5 * Math.max(FRAME, most), bottom, top);
    }

    private static void frame(Drawing drawing, Plot plot, LabelPlacer placer) {
        Spot left = new Spot(plot.box().left(), plot.at(1, FRAME).y());
        Spot right = new Spot(plot.box().right(), left.y());
        drawing.dashed(left.x(), left.y(), right.x(), right.y(), Palette.DIM);
        placer.avoid(left, right);
        Spot at = new Spot(left.x() + 90, left.y());
        placer.place(
                drawing,
                new Label("16.7 ms: 60 steps a second", WORDS, Palette.DIM, at, 4, LABEL_REACH));
    }

    private void line(Drawing drawing, Plot plot, LabelPlacer placer, int engine) {
        List<Spot> spots = new ArrayList<>();
        for (CrowdPoint point : of(engines.get(engine))) {
            Spot spot = plot.at(point.bodies(), point.median());
            if (!spots.isEmpty()) {
                placer.avoid(spots.get(spots.size() - 1), spot);
            }
            spots.add(spot);
        }
        drawing.path(spots, LINE_WIDTH, color(engine));
        for (Spot spot : spots) {
            MARKS[engine % MARKS.length].solid(drawing, spot, RADIUS, color(engine));
        }
    }

    private void label(Drawing drawing, Plot plot, LabelPlacer placer, int engine) {
        List<CrowdPoint> line = of(engines.get(engine));
        CrowdPoint last = line.get(line.size() - 1);
        Spot at = plot.at(last.bodies(), last.median());
        String color = Palette.forLetters(color(engine));
        placer.place(
                drawing, new Label(engines.get(engine), WORDS, color, at, LABEL_GAP, LABEL_REACH));
    }

    private static String color(int engine) {
        return COLORS[engine % COLORS.length];
    }

    private List<CrowdPoint> of(String engine) {
        return points.stream().filter(point -> point.engine().equals(engine)).toList();
    }

    private static String count(double tick) {
        return String.format(Locale.ROOT, "%,.0f", tick);
    }

    /** Sentences that describe the figure. */
    public List<String> sentences() {
        List<String> sentences = new ArrayList<>();
        sentences.add(
                "Discs of r = 0.25 m and elasticity 0.5 fall into a trough of 40 m and settle,"
                    + " without friction and without sleep. Ours runs at GAME, the others at their"
                    + " defaults.");
        for (String engine : engines) {
            List<CrowdPoint> line = of(engine);
            CrowdPoint last = line.get(line.size() - 1);
            sentences.add(
                    String.format(
                            Locale.ROOT,
                            "%s: %s a step for %,d discs, deepest overlap at the end %s %% of a"
                                    + " radius.",
                            engine,
                            Amount.time(last.median() * NANOS_PER_MILLI),
                            last.bodies(),
                            Amount.percent(100 * last.deepest())));
        }
        return sentences;
    }
}
