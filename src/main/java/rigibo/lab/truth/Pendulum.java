package rigibo.lab.truth;

/** The swing about a fixed point. */
public final class Pendulum {

    private static final int MOST_MEANS = 40;
    private static final int HALVINGS = 60;

    private Pendulum() {}

    /**
     * T = 4·√(l/g)·K(sin(α/2)), and K(k) = (π/2)/agm(1, √(1 − k²)) (Gauss).
     *
     * @param length l in m: (I + m·d²)/(m·d) of a body whose centre is d from the point
     * @param amplitude α, rad, below π
     * @return s
     */
    public static double period(double length, double amplitude) {
        double one = 1;
        double other = Math.cos(amplitude / 2);
        for (int i = 0; i < MOST_MEANS && Math.abs(one - other) > Math.ulp(one); i++) {
            double mean = (one + other) / 2;
            other = Math.sqrt(one * other);
            one = mean;
        }
        return 2 * Math.PI * Math.sqrt(length / Earth.GRAVITY) / one;
    }

    /**
     * The time at which a coordinate passes 0 within a step, as a share of it: the zero of the
     * cubic with its values and slopes at both ends, which errs by at most (ωh)⁴/384 of the
     * amplitude.
     *
     * @param from value at the start
     * @param rate of it per step there
     * @param to value at the end, of the other sign
     * @param rateTo of it per step there
     */
    public static double crossing(double from, double rate, double to, double rateTo) {
        double low = 0;
        double high = 1;
        for (int i = 0; i < HALVINGS; i++) {
            double s = (low + high) / 2;
            double value =
                    (1 - s) * (1 - s) * ((1 + 2 * s) * from + s * rate)
                            + s * s * ((3 - 2 * s) * to - (1 - s) * rateTo);
            if (value * from > 0) {
                low = s;
            } else {
                high = s;
            }
        }
        return (low + high) / 2;
    }
}
