package rigibo.lab.bench.scene;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.lab.Flood;

/**
 * Discs that fall into a trough, timed from the first step until they are at rest.
 *
 * <p>They need gravity, contacts, restitution (0.5), friction and the rotation that it causes, and
 * continuous impacts, since they fall by up to their own width in a step.
 */
final class Floods {

    private static final double RADIUS = 0.25;
    private static final double FRICTION = 0.4;
    private static final Effects EFFECTS =
            Flood.FRICTIONLESS.with(new Rotation()).with(new Friction());

    /** The width of the scene's trough, m. */
    private static final double WIDTH = 40;

    /** The number of discs above each other at the start of the sweep's scenes. */
    private static final int DEPTH = 25;

    /** The width of a disc's column at the start, m, as in {@link Flood}. */
    private static final double COLUMN = 0.65;

    /**
     * Added to the width of a trough that its columns fill exactly, m, so that rounding cannot
     * remove a column.
     */
    private static final double SLACK = 0.01;

    private Floods() {}

    /** Discs in the trough of 40 m. */
    static Scene of(int discs) {
        return of(discs, WIDTH);
    }

    /**
     * Discs in a trough whose width gives the same depth for any number of them. If the depth grew
     * as well, the growth of the cost would say less about the engine.
     */
    static Scene asDeepAsAny(int discs) {
        int columns = (discs + DEPTH - 1) / DEPTH;
        return of(discs, columns * COLUMN + 2 * RADIUS + SLACK);
    }

    private static Scene of(int discs, double width) {
        return new Scene(EFFECTS, new Flood(width, RADIUS).bodies(discs, FRICTION));
    }
}
