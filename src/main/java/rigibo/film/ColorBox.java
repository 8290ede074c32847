package rigibo.film;

import java.util.ArrayList;
import java.util.List;

/**
 * Colours that one entry of a palette stands for, until they are split: by median cut (P. Heckbert,
 * Color image quantization for frame buffer display, SIGGRAPH 1982), at the mean instead of the
 * median and across the channel of the greatest variance.
 */
final class ColorBox {

    private static final int CHANNELS = 3;

    private final Histogram histogram;
    private final List<Integer> bins;
    private final double[] mean = new double[CHANNELS];
    private final double[] variance = new double[CHANNELS];
    private double weight;

    ColorBox(Histogram histogram, List<Integer> bins) {
        this.histogram = histogram;
        this.bins = bins;
        for (int bin : bins) {
            double share = weight(bin);
            weight += share;
            for (int channel = 0; channel < CHANNELS; channel++) {
                double level = Histogram.level(bin, channel);
                mean[channel] += share * level;
                variance[channel] += share * level * level;
            }
        }
        for (int channel = 0; channel < CHANNELS; channel++) {
            mean[channel] /= weight;
            variance[channel] -= weight * mean[channel] * mean[channel];
        }
    }

    /**
     * A root, so that a small ring has its colour beside a large ground; the ground keeps enough of
     * them to have no edges.
     */
    private double weight(int bin) {
        return Math.sqrt(histogram.count(bin));
    }

    /** The gain of splitting it; 0 for a single colour. */
    double spread() {
        return bins.size() < 2 ? 0 : variance[widest()];
    }

    private int widest() {
        int widest = 0;
        for (int channel = 1; channel < CHANNELS; channel++) {
            widest = variance[channel] > variance[widest] ? channel : widest;
        }
        return widest;
    }

    /** Both halves; neither is empty, since the mean lies between their colours. */
    List<ColorBox> split() {
        int channel = widest();
        List<Integer> below = new ArrayList<>();
        List<Integer> above = new ArrayList<>();
        for (int bin : bins) {
            (Histogram.level(bin, channel) <= mean[channel] ? below : above).add(bin);
        }
        return List.of(new ColorBox(histogram, below), new ColorBox(histogram, above));
    }

    /** The mean, 0xRRGGBB. */
    int color() {
        int color = 0;
        for (double level : mean) {
            color = color << 8 | (int) Math.round(level);
        }
        return color;
    }
}
