package rigibo.backend.saved;

import rigibo.backend.setup.Accuracy;

/**
 * The settings of an accuracy. Choices are written by name, so that a new choice changes no other.
 */
final class SavedAccuracy {

    private SavedAccuracy() {}

    /** Passes every setting to a codec; returns the resulting accuracy. */
    static Accuracy visit(Accuracy accuracy, Codec codec) {
        codec.label("accuracy");
        return new Accuracy(
                codec.number(accuracy.substeps()),
                codec.number(accuracy.velocityIterations()),
                choice(accuracy.impacts(), codec),
                codec.number(accuracy.impactTolerance()),
                choice(accuracy.search(), codec),
                codec.number(accuracy.maxImpactsPerPair()),
                choice(accuracy.integrator(), codec),
                choice(accuracy.contactSolver(), codec),
                choice(accuracy.correction(), codec));
    }

    private static <E extends Enum<E>> E choice(E chosen, Codec codec) {
        return Enum.valueOf(chosen.getDeclaringClass(), codec.text(chosen.name()));
    }
}
