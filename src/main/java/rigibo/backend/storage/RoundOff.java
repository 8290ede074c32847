package rigibo.backend.storage;

/**
 * Tolerances of round-off that more than one class uses, except for those of the solvers. Each is a
 * share of the operands of a sum, never of the sum itself: where operands cancel, nothing but
 * round-off is left.
 */
public final class RoundOff {

    /**
     * Uncertainty of a place on a body after a change of frame, as a share of the body's width;
     * also the sine of the uncertainty of a direction between such places. It is far above an ulp,
     * since places far from the origin are less exact.
     */
    public static final double OF_PLACES = 1e-9;

    /**
     * Uncertainty of a sum over rows or forces, as a share of its summands: some 4,000 ulp, since
     * far from the origin normals and levers are less exact. Sums over 256 parts stay below.
     */
    public static final double OF_SUMS = 1e-12;

    private RoundOff() {}
}
