package rigibo.lab.truth;

/**
 * A body that falls from the height H and rebounds by e. Truth: the n-th apex is e^(2n)·H; the n-th
 * impact comes at t1·(1 + 2(e + e² + … + e^(n−1))) with t1 = √(2H/g), and for e < 1 all of them
 * before T = t1(1 + e)/(1 − e).
 *
 * <p>In flight y + v²/2g is the apex of the flight at every instant, so every step is a
 * measurement, and flights shorter than a step are measured too.
 */
public final class Bounces {

    private final double height;
    private final double elasticity;
    private final double firstImpact;

    /**
     * The bounces of one body.
     *
     * @param height of the fall, m, positive
     * @param elasticity e, 0 to 1
     */
    public Bounces(double height, double elasticity) {
        this.height = height;
        this.elasticity = elasticity;
        firstImpact = Math.sqrt(2 * height / Earth.GRAVITY);
    }

    /** The height of a fall that takes a time, m. */
    public static double heightOfFall(double seconds) {
        return Earth.GRAVITY * seconds * seconds / 2;
    }

    /** The apex after n impacts, m above the height at which the body touches. */
    public double apex(int n) {
        return Math.pow(elasticity, 2.0 * n) * height;
    }

    /** The apex of the flight at a time, s after the fall began. */
    public double apexAt(double seconds) {
        return apex(impactsUntil(seconds));
    }

    /** The time of the n-th impact, n from 1, s. */
    public double impactTime(int n) {
        double time = firstImpact;
        double flight = 2 * firstImpact;
        for (int i = 1; i < n; i++) {
            flight *= elasticity;
            time += flight;
        }
        return time;
    }

    /** The time at which infinitely many bounces are over, s; infinite for e = 1. */
    public double restTime() {
        return firstImpact * (1 + elasticity) / (1 - elasticity);
    }

    /** The time of the first impact, s. */
    public double firstImpact() {
        return firstImpact;
    }

    /**
     * Error of the present apex as a share of H.
     *
     * @param time s since the fall began
     * @param leeway s by which an impact may be early or late, so that a flight is not compared
     *     with the one before it
     * @param apex apex of the present flight, m above the floor
     */
    public double apexError(double time, double leeway, double apex) {
        int most = impactsUntil(time + leeway);
        double least = Double.POSITIVE_INFINITY;
        for (int n = impactsUntil(time - leeway); n <= most; n++) {
            least = Math.min(least, Math.abs(apex - apex(n)) / height);
        }
        return least;
    }

    /**
     * The apex of a flight, m above the height at which the body touches.
     *
     * @param above that height, m
     * @param velocityY up or down, m/s
     */
    public static double apexOf(double above, double velocityY) {
        return above + velocityY * velocityY / (2 * Earth.GRAVITY);
    }

    private int impactsUntil(double time) {
        int n = 0;
        double next = firstImpact;
        double flight = 2 * firstImpact;
        while (next <= time && flight > 1e-12) {
            n++;
            flight *= elasticity;
            next += flight;
        }
        return n;
    }
}
