package rigibo.lab.child;

import java.util.Arrays;

/**
 * The median of some values and between which of them it lies with 95 %: from the k-th smallest to
 * the k-th largest, where k is the largest for which a fair coin shows fewer than k heads in n
 * throws at most 2.5 % of the time (W. J. Conover, "Practical Nonparametric Statistics", 1999,
 * section 3.2). It holds for every distribution and needs no chance; a bootstrap holds for many
 * values only. Fewer than six values have no such interval: then it is from the least to the
 * greatest, and covers less.
 *
 * @param median of the values
 * @param low lower end
 * @param high upper end
 * @param coverage probability that the true median is within, at least
 */
public record Interval(double median, double low, double high, double coverage) {

    private static final double WANTED = 0.95;

    /** Of one value or more. */
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

    /** Of values in rising order. */
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

    /** Whether all of it is within a distance of a value. */
    public boolean isWithin(double distance, double of) {
        return low >= of - distance && high <= of + distance;
    }
}
