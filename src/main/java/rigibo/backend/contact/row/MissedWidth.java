package rigibo.backend.contact.row;

import rigibo.backend.setup.Accuracy;

/** Residuals that passes may leave in contacts. */
public final class MissedWidth {

    private MissedWidth() {}

    /**
     * Allowed error of a contact in a substep, in widths: the impact tolerance to the power of
     * three quarters, a thousandth at the game's accuracy. The power is below 1 since each pass
     * removes only a share of the error, not a digit.
     */
    public static double of(Accuracy accuracy) {
        double root = Math.sqrt(accuracy.impactTolerance());
        return root * Math.sqrt(root);
    }
}
