package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.EnergyPlate;
import rigibo.frontend.scene.accuracy.StageProfile;
import rigibo.frontend.scene.ghost.GhostPlate;

/** The plate with the frame's time, the energy or the ghost. */
final class SidePlate {

    private final Workbench bench;
    private final StageProfile profile;
    private final EnergyPlate energy;
    private final GhostPlate ghost;

    SidePlate(Workbench bench, Words words) {
        this.bench = bench;
        profile = new StageProfile(words);
        energy = new EnergyPlate(bench.pool(), words);
        ghost = new GhostPlate(words);
    }

    void beforeStep() {
        energy.beforeStep();
    }

    void afterStep() {
        energy.afterStep();
        profile.step(bench.pool().report());
    }

    /** Records the time that drawing took, ns. */
    void drawn(long nanos) {
        profile.drawing(nanos);
    }

    /** Draws one of its sides with the upper left corner at (x, y), px, so wide. */
    void draw(Canvas canvas, Fold side, double x, double y, double width) {
        switch (side) {
            case FRAME -> profile.draw(canvas, x, y, width);
            case ENERGY -> energy.draw(canvas, x, y, width);
            case GHOST -> ghost.draw(canvas, bench.ghost(), x, y, width);
            case CONTROLS, NUMBERS, ACCURACY, EFFECTS ->
                    throw new IllegalArgumentException(side + " is no side");
        }
    }

    /** Height of one of its sides, px. */
    static double height(Fold side) {
        return switch (side) {
            case FRAME -> StageProfile.HEIGHT;
            case ENERGY -> EnergyPlate.HEIGHT;
            case GHOST -> GhostPlate.HEIGHT;
            case CONTROLS, NUMBERS, ACCURACY, EFFECTS ->
                    throw new IllegalArgumentException(side + " is no side");
        };
    }
}
