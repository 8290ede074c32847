package rigibo.frontend.scene.ghost;

import java.util.Arrays;

/**
 * Decides whether a distance grows chaotically: by the same factor in equal times, d = d₀·exp(λt),
 * until it is as large as the scene. Errors that merely add up grow as a power of time, and two
 * bodies that fall to different sides part suddenly.
 */
final class Growth {

    /** Smaller distances are rounding errors, m. */
    private static final double ROUNDING = 1e-14;

    /** From this share of its size on, two pictures of a scene look like two scenes. */
    private static final double SHARE = 0.25;

    /** A minute: what takes longer to be seen is not called chaos here. */
    private static final int MOST = 3600;

    /** A smaller total growth, as a factor, cannot be told from a power of time or from a jump. */
    private static final double LEAST_GROWTH = 100;

    /**
     * The least growth in the later half of the time, as a factor: the third power of time has 8.
     */
    private static final double LEAST_LATER = 8;

    /**
     * The least share of the scatter of log d that a straight line explains. Impacts make a stair
     * of it, with 0.8 and more; one jump alone has at most 0.75.
     */
    private static final double LEAST_STRAIGHT = 0.78;

    private double[] logs = new double[64];
    private int count;

    /** Takes the distance after another step, m; nothing begins before the first difference. */
    void add(double distance) {
        if (isFull() || count == 0 && distance <= ROUNDING) {
            return;
        }
        if (count == logs.length) {
            logs = Arrays.copyOf(logs, 2 * count);
        }
        logs[count++] = Math.log(Math.max(distance, ROUNDING));
    }

    /** Whether no more is taken. */
    boolean isFull() {
        return count == MOST;
    }

    /** Whether the last distance is as large as a scene of a size, m. */
    boolean hasReached(double size) {
        return count > 0 && logs[count - 1] > Math.log(SHARE * size);
    }

    /** Whether all distances so far lie on an exponential. */
    boolean isExponential() {
        if (count < 3) {
            return false;
        }
        double last = logs[count - 1];
        return last - logs[0] > Math.log(LEAST_GROWTH)
                && last - logs[count / 2] > Math.log(LEAST_LATER)
                && straightness() > LEAST_STRAIGHT;
    }

    /** The squared correlation of log d and time. */
    private double straightness() {
        double middle = (count - 1) / 2.0;
        double mean = Arrays.stream(logs, 0, count).average().orElseThrow();
        double together = 0;
        double times = 0;
        double heights = 0;
        for (int i = 0; i < count; i++) {
            double time = i - middle;
            double height = logs[i] - mean;
            together += time * height;
            times += time * time;
            heights += height * height;
        }
        return together * together / (times * heights);
    }
}
