package rigibo.frontend.laboratory;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Panel;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Widget;

import java.util.List;

/** Sliders for the accuracy of each world, under its half of the window. */
final class ExpertPlate {

    private static final double GAP = 8;
    private static final int MOST_SUBSTEPS = 64;
    private static final int MOST_ITERATIONS = 8;
    private static final int MOST_IMPACTS = 64;
    private static final int LEAST_IMPACTS = 4;

    /** Powers of ten of the tolerance of impacts, m. */
    private static final int FINEST = -9;

    private static final int COARSEST = -3;

    private final Words words;
    private final List<LinkedHalf> halves;
    private final List<Panel> panels;

    /** Sliders for the accuracies of the left and the right world, on one plate. */
    ExpertPlate(Words words, Plate plate, Half left, Half right) {
        this.words = words;
        double width = (plate.width() - GAP) / 2;
        halves =
                List.of(
                        new LinkedHalf("left", left, sliders(left)),
                        new LinkedHalf("right", right, sliders(right)));
        panels =
                List.of(
                        new Panel(plate.x(), plate.y(), width, halves.get(0).sliders()),
                        new Panel(
                                plate.right() - width, plate.y(), width, halves.get(1).sliders()));
    }

    /** The accuracies of the two worlds, as links carry them. */
    List<LinkedHalf> halves() {
        return halves;
    }

    private List<Widget> sliders(Half half) {
        return List.of(
                new Slider(
                        words,
                        "laboratory.substeps",
                        "%.0f",
                        1,
                        MOST_SUBSTEPS,
                        1,
                        () -> half.accuracy().substeps(),
                        count -> half.choose(half.accuracy().withSubsteps((int) count))),
                new Slider(
                        words,
                        "laboratory.iterations",
                        "%.0f",
                        1,
                        MOST_ITERATIONS,
                        1,
                        () -> half.accuracy().velocityIterations(),
                        count -> half.choose(half.accuracy().withVelocityIterations((int) count))),
                new Slider(
                        words,
                        "laboratory.tolerance",
                        "1e%.0f m",
                        FINEST,
                        COARSEST,
                        1,
                        () -> Math.log10(half.accuracy().impactTolerance()),
                        power -> half.choose(tolerant(half.accuracy(), power))),
                new Slider(
                        words,
                        "laboratory.impacts",
                        "%.0f",
                        LEAST_IMPACTS,
                        MOST_IMPACTS,
                        1,
                        () -> half.accuracy().maxImpactsPerPair(),
                        count -> half.choose(half.accuracy().withMaxImpactsPerPair((int) count))));
    }

    private static Accuracy tolerant(Accuracy accuracy, double power) {
        return accuracy.withImpactTolerance(Double.parseDouble("1e" + Math.round(power)));
    }

    void draw(Canvas canvas) {
        panels.forEach(panel -> panel.draw(canvas));
    }

    void pointerMoved(double x, double y) {
        panels.forEach(panel -> panel.pointerMoved(x, y));
    }

    void pointerPressed(double x, double y) {
        panels.forEach(panel -> panel.pointerPressed(x, y));
    }

    void pointerReleased() {
        panels.forEach(Panel::pointerReleased);
    }
}
