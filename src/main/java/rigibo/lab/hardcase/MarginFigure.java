package rigibo.lab.hardcase;

import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.LogScale;
import rigibo.lab.plot.Mark;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Spot;
import rigibo.lab.report.Amount;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** A figure of the margins of all cases at all presets, with crosses where a limit is broken. */
public final class MarginFigure {

    private static final int TITLE = 18;
    private static final int WORDS = 13;
    private static final double ROW = 22;
    private static final double HEAD = 84;
    private static final double LEFT = 130;
    private static final double RIGHT = 24;
    private static final double RADIUS = 5;

    /** The range of margins that is drawn; others are at its edge. */
    private static final double LEAST = 0.003;

    private static final double MOST = 1e6;
    private static final Map<Preset, Mark> MARKS =
            Map.of(
                    Preset.DRAFT, Mark.DISC,
                    Preset.GAME, Mark.SQUARE,
                    Preset.FINE, Mark.DIAMOND,
                    Preset.EXACT, Mark.UP);
    private static final Map<Preset, String> COLORS =
            Map.of(
                    Preset.DRAFT, Palette.SKY,
                    Preset.GAME, Palette.BLUE,
                    Preset.FINE, Palette.GREEN,
                    Preset.EXACT, Palette.INK);

    private final Map<String, List<Margin>> rows = new LinkedHashMap<>();
    private final List<Margin> margins;

    /** A figure of margins. */
    public MarginFigure(List<Margin> margins) {
        this.margins = margins;
        for (Margin margin : margins) {
            rows.computeIfAbsent(margin.row(), row -> new ArrayList<>()).add(margin);
        }
    }

    /** Draws the figure with a width in px. */
    public Drawing drawing(double width) {
        Drawing drawing = new Drawing(width);
        drawing.text(
                10,
                TITLE + 8,
                Anchor.START,
                TITLE,
                Palette.INK,
                "How far each hard case is from its limit");
        LogScale across = new LogScale(LEAST, MOST, LEFT, width - RIGHT);
        double bottom = HEAD + ROW * rows.size();
        key(drawing);
        for (double tick : across.ticks()) {
            double x = across.at(tick);
            drawing.line(x, HEAD, x, bottom, 1, Palette.GRID);
            String words =
                    tick < 1000 ? plain(tick) : Amount.power((int) Math.rint(Math.log10(tick)));
            drawing.text(x, bottom + WORDS + 8, Anchor.MIDDLE, WORDS, Palette.DIM, words);
        }
        drawing.line(across.at(1), HEAD, across.at(1), bottom, 2, Palette.DIM);
        double y = HEAD + ROW / 2;
        for (Map.Entry<String, List<Margin>> row : rows.entrySet()) {
            drawing.text(LEFT - 10, y + 5, Anchor.END, WORDS, Palette.INK, row.getKey());
            for (Margin margin : row.getValue()) {
                mark(drawing, across, y, margin);
            }
            y += ROW;
        }
        drawing.text(
                width - RIGHT,
                bottom + 44,
                Anchor.END,
                WORDS,
                Palette.DIM,
                "limit / figure, of the figure that comes nearest to its limit →");
        drawing.endAt(bottom + 58);
        return drawing;
    }

    private static void key(Drawing drawing) {
        double x = LEFT;
        for (Preset preset : Preset.values()) {
            Spot at = new Spot(x, HEAD - 24);
            MARKS.get(preset).solid(drawing, at, RADIUS + 1, COLORS.get(preset));
            drawing.text(x + 12, HEAD - 19, Anchor.START, WORDS, Palette.INK, preset.name());
            x += 78;
        }
    }

    private static void mark(Drawing drawing, LogScale across, double y, Margin margin) {
        Preset preset = margin.preset();
        double times = Math.max(LEAST, Math.min(MOST, margin.worst().margin()));
        Spot at = new Spot(across.at(times), y);
        if (margin.passes()) {
            MARKS.get(preset).solid(drawing, at, RADIUS, COLORS.get(preset));
        } else {
            Mark.cross(drawing, at, RADIUS, COLORS.get(preset));
        }
    }

    private static String plain(double tick) {
        return String.format(Locale.ROOT, "%.3f", tick).replaceAll("\\.?0+$", "");
    }

    /** Sentences that describe the figure. */
    public List<String> sentences() {
        long passed = margins.stream().filter(Margin::passes).count();
        List<String> sentences = new ArrayList<>();
        sentences.add(
                String.format(
                        Locale.ROOT,
                        "%d of %d cases keep their limits; each is held to a closed form or an"
                                + " invariant, without sleep.",
                        passed,
                        margins.size()));
        for (Margin margin : margins) {
            if (!margin.passes()) {
                Measure worst = margin.worst();
                sentences.add(
                        String.format(
                                Locale.ROOT,
                                "%s at %s fails: %s %.3g, at most %.3g %s.",
                                margin.row(),
                                margin.preset(),
                                worst.name(),
                                worst.figure(),
                                worst.limit(),
                                worst.unit()));
            }
        }
        return sentences;
    }
}
