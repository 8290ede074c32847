package rigibo.backend.storage;

/**
 * What counts as round-off outside the solvers, where more than one class asks. A share is of the
 * sizes that go into a number, never of the number itself: what cancels is nothing but round-off.
 */
public final class RoundOff {

    /**
     * Share of a body's width by which a place on it is uncertain, once it was carried from one
     * frame to another; and the sine of the angle by which a direction between such places is. It
     * is far above an ulp, since a place far from the origin is less exact.
     */
    public static final double OF_PLACES = 1e-9;

    /**
     * Share of what is summed by which a sum over rows or forces is uncertain: some 4,000 ulp,
     * since far from the origin normals and levers are less exact. Sums over 256 parts stay below.
     */
    public static final double OF_SUMS = 1e-12;

    private RoundOff() {}
}
