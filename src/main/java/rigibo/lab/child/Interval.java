package rigibo.lab.child;

import java.util.Arrays;

/**
 * The median of some values with its 95 % confidence interval, from the k-th smallest to the k-th
 * largest value. Here k is the largest number for which a fair coin shows fewer than k heads in n
 * throws at most 2.5 % of the time (W. J. Conover, "Practical Nonparametric Statistics", 1999,
 * section 3.2). The interval holds for every distribution and needs no random numbers; a bootstrap
 * holds only for many values. Fewer than six values have no such interval: theirs reaches from the
 * smallest to the largest and covers less.
 *
 * @param median of the values
 * @param low lower end
 * @param high upper end
 * @param coverage probability that the true median is within, at least
 */
public record Interval(double median, double low, double high, double coverage) {

    private static final double WANTED = 0.95;

    /** The interval of one or more values. */
    public static Interval of(double... values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int n = sorted.length;
        int left = 0;
        while (left + 1 < n / 2 && coverage(n, left + 1) >= WANTED) {
            left++;
        }
        return new Interval(median(sorted), sorted[left], sorted[n - 1 - left], coverage(n, left));
    }

    /** The median of sorted values. */
    private static double median(double[] sorted) {
        int half = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
    }

    /** 1 − 2·P(X ≤ left) for X heads in n throws. */
    private static double coverage(int n, int left) {
        double ways = 1;
        double sum = 0;
        for (int heads = 0; heads <= left; heads++) {
            sum += ways;
            ways = ways * (n - heads) / (heads + 1);
        }
        return Math.max(0, 1 - 2 * sum / Math.pow(2, n));
    }

    /** Whether a number lies within. */
    public boolean contains(double value) {
        return low <= value && value <= high;
    }

    /** Whether the whole interval is within a distance of a value. */
    public boolean isWithin(double distance, double of) {
        return low >= of - distance && high <= of + distance;
    }
}
