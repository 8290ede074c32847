package rigibo.lab.problem;

import java.util.Arrays;

/** Of errors, over the phases of a problem. */
final class Mean {

    private Mean() {}

    /** The arithmetic mean; not finite as soon as one of them is not. */
    static double of(double... errors) {
        return Arrays.stream(errors).sum() / errors.length;
    }
}
