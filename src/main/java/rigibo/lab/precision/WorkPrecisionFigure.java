package rigibo.lab.precision;

import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Box;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.LabelPlacer;
import rigibo.lab.plot.Letters;
import rigibo.lab.plot.LogScale;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Plot;
import rigibo.lab.plot.Spot;
import rigibo.lab.report.Amount;

import java.util.ArrayList;
import java.util.List;

/** A figure of error over cost, with every setting of every engine at one problem. */
final class WorkPrecisionFigure {

    private static final int TITLE = 18;
    private static final int SMALL = 12;
    private static final double LINE = 20;
    private static final double FRONT_WIDTH = 9;

    private final Asked asked;
    private final FigureSize size;
    private final PlotRange range;
    private final Drawing drawing;

    WorkPrecisionFigure(Asked asked, FigureSize size) {
        this.asked = asked;
        this.size = size;
        range = new PlotRange(asked);
        drawing = new Drawing(size.width());
    }

    /** Whether there is anything to draw. */
    static boolean isOf(Asked asked) {
        return !new PlotRange(asked).drawn().isEmpty();
    }

    /** Draws the figure. */
    Drawing drawing() {
        double y = head();
        FailureBand failures = new FailureBand(asked, size.plotRight() - size.left());
        double top = y + failures.height();
        double bottom = top + size.height();
        LogScale across = range.across(size.left(), size.plotRight());
        failures.draw(drawing, across, y);
        Plot plot = new Plot(drawing, across, range.up(bottom, top));
        plot.grid(Amount::roundTime, this::errorWords);
        LabelPlacer placer = new LabelPlacer(plot.box());
        front(plot);
        limit(ObservedOrder.ROUND_OFF, "less is rounding", plot, placer);
        limit(asked.problem().equalBelow(), "EXACT promises less", plot, placer);
        Key key = new Key();
        new WorkPrecisionMarks(asked, drawing, plot, size, placer).draw(key);
        y = foot(bottom);
        drawing.endAt(key.draw(drawing, size, y) + LINE / 2);
        return drawing;
    }

    private double head() {
        double y = TITLE + 8;
        String title = asked.problem().id() + " · " + asked.problem().title();
        for (String words : Letters.lines(title, TITLE, size.width() - 20)) {
            drawing.text(10, y, Anchor.START, TITLE, Palette.INK, words);
            y += LINE + 4;
        }
        String error = "↑ error: " + asked.problem().error();
        for (String words : Letters.lines(error, size.words(), size.width() - 20)) {
            drawing.text(10, y, Anchor.START, size.words(), Palette.DIM, words);
            y += LINE;
        }
        return y - LINE / 2;
    }

    private double foot(double bottom) {
        double y = bottom + 44;
        String words = "processor time for one simulated second →";
        drawing.text(size.plotRight(), y, Anchor.END, size.words(), Palette.DIM, words);
        return y + LINE / 2;
    }

    private String errorWords(double error) {
        boolean isEdge = error == range.leastError() && range.reachesBelow();
        return (isEdge ? "≤ " : "") + tick(error);
    }

    private static String tick(double error) {
        double power = Math.log10(error);
        boolean isPower = Math.abs(power - Math.rint(power)) < 1e-9;
        return isPower ? Amount.power((int) Math.rint(power)) : Amount.scientific(error);
    }

    /**
     * Draws the front as steps: from each point to the cost of the next more expensive one with a
     * smaller error.
     */
    private void front(Plot plot) {
        List<Spot> steps = new ArrayList<>();
        for (Point point : asked.front().points()) {
            Spot spot = plot.at(point.cost(), point.errors().main());
            if (!steps.isEmpty()) {
                steps.add(new Spot(spot.x(), steps.get(steps.size() - 1).y()));
            }
            steps.add(spot);
        }
        if (!steps.isEmpty()) {
            steps.add(new Spot(plot.box().right(), steps.get(steps.size() - 1).y()));
            drawing.path(steps, FRONT_WIDTH, Palette.BAND);
        }
    }

    /** The name stands on the left, where marks are rarest, since little is exact and cheap. */
    private void limit(double error, String words, Plot plot, LabelPlacer placer) {
        if (error < range.leastError()) {
            return;
        }
        double left = plot.box().left();
        double y = plot.at(0, error).y();
        drawing.dashed(left, y, plot.box().right(), y, Palette.DIM);
        drawing.text(left + 4, y - 5, Anchor.START, SMALL, Palette.DIM, words);
        placer.keepFree(Box.of(left + 4, y - 5, Anchor.START, SMALL, words));
    }
}
