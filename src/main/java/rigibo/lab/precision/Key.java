package rigibo.lab.precision;

import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Letters;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Picture;
import rigibo.lab.plot.Spot;

import java.util.LinkedHashMap;
import java.util.Map;

/** The names below a plot for which it had no room. */
final class Key {

    private static final double ROW = 24;
    private static final double SAMPLE = 16;
    private static final double BETWEEN = 26;

    private final Map<String, Look> entries = new LinkedHashMap<>();

    void add(Look look, String words) {
        entries.put(words, look);
    }

    /** Draws it below a height and returns its lower edge. */
    double draw(Picture picture, FigureSize size, double top) {
        double x = size.left();
        double y = top;
        for (Map.Entry<String, Look> entry : entries.entrySet()) {
            double width = SAMPLE + Letters.width(entry.getKey(), size.words());
            if (x > size.left() && x + width > size.plotRight()) {
                x = size.left();
                y += ROW;
            }
            entry.getValue().draw(picture, new Spot(x + SAMPLE / 2 - 2, y + ROW / 2));
            picture.text(
                    x + SAMPLE,
                    y + ROW / 2 + 5,
                    Anchor.START,
                    size.words(),
                    Palette.INK,
                    entry.getKey());
            x += width + BETWEEN;
        }
        return entries.isEmpty() ? top : y + ROW;
    }
}
