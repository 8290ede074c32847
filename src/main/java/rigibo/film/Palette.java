package rigibo.film;

import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;

/** The colours of a film: 255, and one that leaves a pixel as it was. */
final class Palette {

    /** The entry that leaves a pixel as it was. */
    static final int UNCHANGED = 255;

    private static final int SIZE = 256;
    private static final int UNKNOWN = -1;

    private final int[] colors;

    /** The nearest entry of each bin, once it was asked for. */
    private final int[] nearest = new int[Histogram.BINS];

    private Palette(int[] colors) {
        this.colors = colors;
        Arrays.fill(nearest, UNKNOWN);
    }

    /** The palette that suits some frames best. */
    static Palette of(List<Frame> frames) {
        Histogram histogram = new Histogram();
        frames.forEach(histogram::add);
        List<Integer> bins = new ArrayList<>();
        for (int bin = 0; bin < Histogram.BINS; bin++) {
            if (histogram.count(bin) > 0) {
                bins.add(bin);
            }
        }
        PriorityQueue<ColorBox> boxes =
                new PriorityQueue<>(Comparator.comparingDouble(ColorBox::spread).reversed());
        boxes.add(new ColorBox(histogram, bins));
        while (boxes.size() < UNCHANGED && boxes.peek().spread() > 0) {
            boxes.addAll(boxes.poll().split());
        }
        return new Palette(boxes.stream().mapToInt(ColorBox::color).toArray());
    }

    /** The entry nearest to a colour. */
    int entry(int color) {
        int bin = Histogram.bin(color);
        if (nearest[bin] == UNKNOWN) {
            nearest[bin] = search(bin);
        }
        return nearest[bin];
    }

    private int search(int bin) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < colors.length; i++) {
            int red = Histogram.level(bin, 0) - (colors[i] >> 16);
            int green = Histogram.level(bin, 1) - (colors[i] >> 8 & 0xff);
            int blue = Histogram.level(bin, 2) - (colors[i] & 0xff);
            int distance = red * red + green * green + blue * blue;
            if (distance < least) {
                least = distance;
                best = i;
            }
        }
        return best;
    }

    /** As AWT has it. */
    IndexColorModel model() {
        return new IndexColorModel(
                8, SIZE, Arrays.copyOf(colors, SIZE), 0, false, UNCHANGED, DataBuffer.TYPE_BYTE);
    }
}
