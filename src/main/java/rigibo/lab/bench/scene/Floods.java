package rigibo.lab.bench.scene;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.lab.Flood;

/**
 * Discs that fall into a trough, timed from the first step on until they lie.
 *
 * <p>They call for gravity, contacts, restitution (0.5), continuous impacts, since they fall by up
 * to their own width in a step, and friction with the rotation that it causes.
 */
final class Floods {

    private static final double RADIUS = 0.25;
    private static final double FRICTION = 0.4;
    private static final Effects EFFECTS =
            Flood.FRICTIONLESS.with(new Rotation()).with(new Friction());

    /** Of the trough of the scene, m. */
    private static final double WIDTH = 40;

    /** Discs above each other in a sweep over sizes, as they begin. */
    private static final int DEPTH = 25;

    /** Width of the column that a disc begins in, m, as {@link Flood} has it. */
    private static final double COLUMN = 0.65;

    /** On top of a trough that so many columns just fit in, m: no rounding takes one away. */
    private static final double SLACK = 0.01;

    private Floods() {}

    /** So many discs, into the trough of 40 m. */
    static Scene of(int discs) {
        return of(discs, WIDTH);
    }

    /**
     * So many discs, into a trough as wide as makes them as deep as any other number of them. A
     * deeper flood would cost more by the depth too, and its growth would say less of the engine.
     */
    static Scene asDeepAsAny(int discs) {
        int columns = (discs + DEPTH - 1) / DEPTH;
        return of(discs, columns * COLUMN + 2 * RADIUS + SLACK);
    }

    private static Scene of(int discs, double width) {
        return new Scene(EFFECTS, new Flood(width, RADIUS).bodies(discs, FRICTION));
    }
}
