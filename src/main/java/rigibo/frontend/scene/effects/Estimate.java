package rigibo.frontend.scene.effects;

import java.util.Arrays;

/** An estimate of a repeatedly measured time: the mean of the last rounds and its uncertainty. */
final class Estimate {

    /** Rounds that count. The scene changes, so that older measurements no longer hold. */
    static final int ROUNDS = 9;

    /** Fewest rounds that give an estimate. */
    static final int FEWEST = 3;

    /** Half the width of a 95 % interval in standard errors, Student's t of nine rounds. */
    private static final double INTERVAL = 2.31;

    private final double[] rounds = new double[ROUNDS];
    private int count;

    void add(double nanos) {
        rounds[count % ROUNDS] = nanos;
        count++;
    }

    boolean isKnown() {
        return count >= FEWEST;
    }

    /** ns; 0 before the first round. */
    double mean() {
        return Arrays.stream(rounds, 0, size()).average().orElse(0);
    }

    /** Half the width of the mean's 95 % interval, ns; 0 before the second round. */
    double noise() {
        double mean = mean();
        double squares = Arrays.stream(rounds, 0, size()).map(x -> (x - mean) * (x - mean)).sum();
        return size() < 2 ? 0 : INTERVAL * Math.sqrt(squares / (size() - 1) / size());
    }

    private int size() {
        return Math.min(count, ROUNDS);
    }
}
