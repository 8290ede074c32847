package rigibo.backend.broadphase;

/**
 * Comparisons of boxes with one branch. Whether two boxes are apart along one axis is as good as
 * chance to a processor, and guessing wrong costs as much as all four subtractions; whether they
 * meet it foresees well, for they seldom do.
 */
final class Signs {

    private Signs() {}

    /** Whether none of four finite differences is less than 0. */
    static boolean none(double one, double two, double three, double four) {
        return (Double.doubleToRawLongBits(one)
                        | Double.doubleToRawLongBits(two)
                        | Double.doubleToRawLongBits(three)
                        | Double.doubleToRawLongBits(four))
                >= 0;
    }
}
