package rigibo.lab.problem;

import java.util.Arrays;

/** The mean of errors over the phases of a problem. */
final class Mean {

    private Mean() {}

    /** The arithmetic mean; not finite if one of the values is not. */
    static double of(double... errors) {
        return Arrays.stream(errors).sum() / errors.length;
    }
}
