package rigibo.lab.precision;

import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.Label;
import rigibo.lab.plot.LabelPlacer;
import rigibo.lab.plot.LinearScale;
import rigibo.lab.plot.LogScale;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Plot;
import rigibo.lab.plot.Scale;
import rigibo.lab.plot.Spot;
import rigibo.lab.report.Amount;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A figure with the energy of the ball and its true energy above, and their difference below. */
final class EnergyFigure {

    private static final int TITLE = 18;
    private static final int WORDS = 14;
    private static final double LEFT = 58;
    private static final double RIGHT = 20;
    private static final double ENERGY_HEIGHT = 230;
    private static final double DRIFT_HEIGHT = 260;
    private static final double DESIGN_WIDTH = 9;
    private static final double LINE_WIDTH = 2;

    /** The smallest drift that is drawn: the last digit of a double. */
    private static final double LEAST_DRIFT = 1e-16;

    private static final double LABEL_GAP = 6;
    private static final double LABEL_REACH = 90;

    /** The colours of our presets, the finer the darker, and of other engines. */
    private static final String[] OURS = {Palette.SKY, Palette.BLUE, Palette.GREEN, Palette.INK};

    private static final String[] OTHERS = {Palette.VERMILLION, Palette.PURPLE, Palette.ORANGE};

    private final List<EnergyTrace> ours;
    private final List<EnergyTrace> others;

    /**
     * A figure.
     *
     * @param ours one trace for each preset
     * @param others one trace for each other engine, at its defaults
     */
    EnergyFigure(List<EnergyTrace> ours, List<EnergyTrace> others) {
        this.ours = ours;
        this.others = others;
    }

    /** Draws the figure with a width in px. */
    Drawing drawing(double width) {
        Drawing drawing = new Drawing(width);
        double y = TITLE + 8;
        drawing.text(
                10, y, Anchor.START, TITLE, Palette.INK, "Energy of a ball that bounces, e = 0.8");
        y += 24;
        drawing.text(
                10, y, Anchor.START, WORDS, Palette.DIM, "↑ share of the energy it began with");
        double energyBottom = y + 14 + ENERGY_HEIGHT;
        energy(drawing, width, y + 14, energyBottom);
        y = energyBottom + 52;
        drawing.text(
                10, y, Anchor.START, WORDS, Palette.DIM, "↑ drift: how far from what it should be");
        double driftBottom = y + 14 + DRIFT_HEIGHT;
        drift(drawing, width, y + 14, driftBottom);
        drawing.text(width - RIGHT, driftBottom + 40, Anchor.END, WORDS, Palette.DIM, "seconds →");
        drawing.endAt(driftBottom + 54);
        return drawing;
    }

    private Scale seconds(double width) {
        double[] seconds = ours.get(0).seconds();
        return new LinearScale(0, seconds[seconds.length - 1], LEFT, width - RIGHT);
    }

    private void energy(Drawing drawing, double width, double top, double bottom) {
        Plot plot = new Plot(drawing, seconds(width), new LinearScale(0, 1.1, bottom, top));
        plot.grid(EnergyFigure::plain, EnergyFigure::plain);
        LabelPlacer placer = new LabelPlacer(plot.box());
        EnergyTrace first = ours.get(0);
        path(drawing, plot, placer, first.seconds(), first.byDesign(), DESIGN_WIDTH, Palette.BAND);
        for (int i = 0; i < others.size(); i++) {
            EnergyTrace one = others.get(i);
            path(drawing, plot, placer, one.seconds(), one.energy(), LINE_WIDTH, other(i));
        }
        for (int i = 0; i < ours.size(); i++) {
            EnergyTrace one = ours.get(i);
            path(drawing, plot, placer, one.seconds(), one.energy(), LINE_WIDTH, OURS[i]);
        }
        Spot lost = plot.at(first.seconds()[first.seconds().length / 2], 0.75);
        placer.place(
                drawing,
                new Label(
                        "what is missing above is lost by design",
                        WORDS,
                        Palette.DIM,
                        lost,
                        0,
                        LABEL_REACH));
    }

    private void drift(Drawing drawing, double width, double top, double bottom) {
        Plot plot = new Plot(drawing, seconds(width), new LogScale(LEAST_DRIFT, 10, bottom, top));
        plot.grid(EnergyFigure::plain, tick -> Amount.power((int) Math.rint(Math.log10(tick))));
        LabelPlacer placer = new LabelPlacer(plot.box());
        List<Label> labels = new ArrayList<>();
        for (int i = 0; i < others.size(); i++) {
            labels.add(
                    drift(drawing, plot, placer, others.get(i), other(i), others.get(i).engine()));
        }
        for (int i = 0; i < ours.size(); i++) {
            labels.add(drift(drawing, plot, placer, ours.get(i), OURS[i], ours.get(i).setting()));
        }
        labels.forEach(label -> placer.place(drawing, label));
    }

    private static Label drift(
            Drawing drawing,
            Plot plot,
            LabelPlacer placer,
            EnergyTrace trace,
            String color,
            String name) {
        double[] drawn = trace.drift().clone();
        for (int i = 0; i < drawn.length; i++) {
            drawn[i] = Math.max(LEAST_DRIFT, drawn[i]);
        }
        path(drawing, plot, placer, trace.seconds(), drawn, LINE_WIDTH, color);
        int last = drawn.length * 4 / 5;
        Spot at = plot.at(trace.seconds()[last], drawn[last]);
        return new Label(name, WORDS, Palette.forLetters(color), at, LABEL_GAP, LABEL_REACH);
    }

    private static void path(
            Drawing drawing,
            Plot plot,
            LabelPlacer placer,
            double[] seconds,
            double[] values,
            double width,
            String color) {
        List<Spot> spots = new ArrayList<>();
        for (int i = 0; i < values.length; i++) {
            spots.add(plot.at(seconds[i], values[i]));
            if (i > 0) {
                placer.avoid(spots.get(i - 1), spots.get(i));
            }
        }
        drawing.path(spots, width, color);
    }

    private static String other(int index) {
        return OTHERS[index % OTHERS.length];
    }

    private static String plain(double tick) {
        return String.format(Locale.ROOT, "%.3g", tick).replaceAll("\\.?0+$", "");
    }

    /** Sentences that describe the figure. */
    List<String> sentences() {
        List<String> sentences = new ArrayList<>();
        sentences.add(
                "A ball falls 2 m and rebounds with e = 0.8. In truth each impact takes 36 % of its"
                        + " energy, and flight keeps it. Any other change is drift.");
        StringBuilder drifts =
                new StringBuilder("The largest drift, as a share of the energy at the start, is ");
        for (EnergyTrace trace : ours) {
            drifts.append(Amount.scientific(trace.most()))
                    .append(" at ")
                    .append(trace.setting())
                    .append(", ");
        }
        for (EnergyTrace trace : others) {
            drifts.append(Amount.scientific(trace.most()))
                    .append(" by ")
                    .append(trace.engine())
                    .append(" at its defaults, ");
        }
        sentences.add(drifts.substring(0, drifts.length() - 2) + ".");
        return sentences;
    }
}
