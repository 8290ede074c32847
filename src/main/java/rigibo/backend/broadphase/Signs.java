package rigibo.backend.broadphase;

/**
 * Comparisons of boxes with one branch. A processor cannot predict whether two boxes are apart
 * along one axis, and a wrong guess costs as much as all four subtractions. It predicts well
 * whether they overlap, since they seldom do.
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
