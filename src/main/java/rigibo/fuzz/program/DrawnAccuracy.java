package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.constant;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Correction;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.ImpactSearch;
import rigibo.backend.setup.Integrator;
import rigibo.fuzz.chance.Chance;

/** Draws an accuracy: a preset, or each knob separately. */
final class DrawnAccuracy {

    private static final double LEAST_TOLERANCE = 1e-9;
    private static final double MOST_TOLERANCE = 1e-3;

    private DrawnAccuracy() {}

    static Stated<Accuracy> draw(Chance chance) {
        return chance.happens(0.5) ? preset(chance) : knobs(chance);
    }

    private static Stated<Accuracy> preset(Chance chance) {
        return switch (chance.whole(0, 3)) {
            case 0 -> new Stated<>("Accuracy.DRAFT", () -> Accuracy.DRAFT);
            case 1 -> new Stated<>("Accuracy.GAME", () -> Accuracy.GAME);
            case 2 -> new Stated<>("Accuracy.FINE", () -> Accuracy.FINE);
            default -> new Stated<>("Accuracy.EXACT", () -> Accuracy.EXACT);
        };
    }

    private static Stated<Accuracy> knobs(Chance chance) {
        Accuracy drawn =
                new Accuracy(
                        chance.happens(0.05) ? 64 : chance.whole(1, 8),
                        chance.whole(1, 8),
                        chance.oneOf(ImpactMode.values()),
                        chance.ofAnySize(LEAST_TOLERANCE, MOST_TOLERANCE),
                        chance.oneOf(ImpactSearch.values()),
                        chance.oneOf(4, 16, 64),
                        chance.oneOf(Integrator.values()),
                        chance.oneOf(ContactSolver.values()),
                        chance.oneOf(Correction.values()));
        return new Stated<>(java(drawn), () -> drawn);
    }

    private static String java(Accuracy knobs) {
        return String.join(
                ", ",
                "new Accuracy(" + knobs.substeps(),
                "" + knobs.velocityIterations(),
                constant(knobs.impacts()),
                "" + knobs.impactTolerance(),
                constant(knobs.search()),
                "" + knobs.maxImpactsPerPair(),
                constant(knobs.integrator()),
                constant(knobs.contactSolver()),
                constant(knobs.correction()) + ")");
    }
}
