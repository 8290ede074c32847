package rigibo.backend.contact.row;

import rigibo.backend.setup.Accuracy;

/** How much work an accuracy is worth: its number of substeps beside those of the presets. */
public final class Effort {

    private Effort() {}

    /** Whether work is not limited by what it costs: from the substeps of EXACT on. */
    public static boolean isExact(Accuracy accuracy) {
        return accuracy.substeps() >= Accuracy.EXACT.substeps();
    }

    /** Whether there are at least as many substeps as at GAME. */
    public static boolean isThorough(Accuracy accuracy) {
        return accuracy.substeps() >= Accuracy.GAME.substeps();
    }

    /** Number of substeps as a multiple of that of GAME. */
    public static double timesGame(Accuracy accuracy) {
        return accuracy.substeps() / (double) Accuracy.GAME.substeps();
    }
}
