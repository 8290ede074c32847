package rigibo.docs.site;

import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.LogScale;
import rigibo.lab.plot.Mark;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Plot;
import rigibo.lab.plot.Spot;
import rigibo.lab.report.Amount;

import java.util.List;
import java.util.Locale;

/** A small plot of a problem: error against the time of a step, ours and those of other engines. */
final class WorkPrecision {

    private static final double WIDTH = 320; // px
    private static final double HEIGHT = 230; // px
    private static final double LEFT = 50; // px
    private static final double RIGHT = 14; // px
    private static final double TOP = 12; // px
    private static final double BOTTOM = 30; // px
    private static final double RADIUS = 5; // px

    /** Errors that all plots show; what is less is round-off, and is drawn at the lower end. */
    private static final double LEAST = 1e-16;

    private static final double MOST = 1e2;

    /** How far a plot goes on beyond the least and the greatest time, as a ratio. */
    private static final double ROOM = 1.6;

    private WorkPrecision() {}

    /** How an engine's readings look. */
    enum Look {
        OURS("RigiBo", Palette.BLUE, Mark.DISC),
        BOX2D("Box2D", Palette.SKY, Mark.DOWN),
        RAPIER("Rapier", Palette.ORANGE, Mark.HEXAGON),
        JBOX2D("JBox2D", Palette.PURPLE, Mark.SQUARE),
        DYN4J("dyn4j", Palette.GREEN, Mark.UP),
        GDX("gdx-box2d", Palette.VERMILLION, Mark.DIAMOND);

        final String words;
        final String color;
        final Mark mark;

        Look(String words, String color, Mark mark) {
            this.words = words;
            this.color = color;
            this.mark = mark;
        }

        static Look of(Reading reading) {
            for (Look look : values()) {
                if (reading.engine()
                        .toLowerCase(Locale.ROOT)
                        .startsWith(look.words.toLowerCase(Locale.ROOT))) {
                    return look;
                }
            }
            if (reading.isOurs()) {
                return OURS;
            }
            throw new IllegalArgumentException("no look for " + reading.engine());
        }

        /** The mark by itself, beside its name. */
        String legend() {
            Drawing drawing = new Drawing(4 * RADIUS);
            drawing.endAt(4 * RADIUS);
            mark.solid(drawing, new Spot(2 * RADIUS, 2 * RADIUS), RADIUS, color);
            return drawing.svg();
        }
    }

    /** The plot as SVG. */
    static String svg(List<Reading> readings) {
        double least = readings.stream().mapToDouble(Reading::seconds).min().orElseThrow();
        double most = readings.stream().mapToDouble(Reading::seconds).max().orElseThrow();
        Drawing drawing = new Drawing(WIDTH);
        drawing.endAt(HEIGHT);
        Plot plot =
                new Plot(
                        drawing,
                        new LogScale(least / ROOM, most * ROOM, LEFT, WIDTH - RIGHT),
                        new LogScale(LEAST, MOST, HEIGHT - BOTTOM, TOP));
        plot.grid(Amount::roundTime, error -> Amount.power((int) Math.round(Math.log10(error))));
        List<Reading> ours = readings.stream().filter(Reading::isOurs).toList();
        drawing.path(ours.stream().map(it -> spot(plot, it)).toList(), 2, Look.OURS.color);
        readings.stream().filter(it -> !it.isOurs()).forEach(it -> mark(plot, drawing, it));
        ours.forEach(it -> mark(plot, drawing, it));
        return drawing.svg();
    }

    private static Spot spot(Plot plot, Reading reading) {
        double error = reading.failed() ? MOST : Math.max(LEAST, reading.error());
        return plot.at(reading.seconds(), error);
    }

    private static void mark(Plot plot, Drawing drawing, Reading reading) {
        Look look = Look.of(reading);
        Spot at = spot(plot, reading);
        if (reading.failed()) {
            Mark.cross(drawing, at, RADIUS, look.color);
        } else {
            look.mark.solid(drawing, at, RADIUS, look.color);
        }
    }
}
