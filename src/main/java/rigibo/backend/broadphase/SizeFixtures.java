package rigibo.backend.broadphase;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Outline;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/**
 * Computes fixtures. A fixture holds the box that a shape sweeps in the next step, and a margin, so
 * that it need not be replaced in every step. One shape is swept at a time; the other methods refer
 * to the shape that was swept last.
 */
final class SizeFixtures {

    /**
     * Margin round a fixture as a share of the body's bounding radius; a larger one means fewer new
     * fixtures, but more pairs.
     */
    private static final double MARGIN = 0.1;

    /**
     * Steps of motion that a fixture is extended by, up to one radius. A moving body then keeps its
     * fixture for some steps, instead of leaving the margin in each.
     */
    private static final double STEPS_AHEAD = 3;

    /**
     * Least number of those steps for a body without neighbours. Such a body seldom gets a
     * neighbour, and when it does, it gets a new fixture. The number differs from body to body,
     * since bodies thrown alike would otherwise all leave their fixtures in the same step.
     */
    private static final int LEAST_AHEAD_ALONE = 8;

    private static final int BITS_AHEAD_ALONE = 4;

    /** Multiples of the golden ratio spread close numbers, as in a hash table. */
    private static final long SPREAD = 0x9E3779B97F4A7C15L;

    /** Mantissa bits of a double, without sign and exponent. */
    private static final long DIGITS = (1L << 52) - 1;

    /** Factor by which a fixture may be larger than a new one before it is replaced. */
    private static final double LOOSE = 1.25;

    private final Bodies bodies;

    /** The box that the present shape sweeps. */
    private final Aabb swept = new Aabb();

    private final Aabb part = new Aabb();

    SizeFixtures(Bodies bodies) {
        this.bodies = bodies;
    }

    /** Distance in m by which turning may move the outline in dt seconds. */
    double turned(int body, double dt) {
        return Math.abs(bodies.spin[body]) * dt * bodies.sweepRadius[body];
    }

    /**
     * Sweeps a shape for dt seconds; turning extends it by at most {@code turned} m, and never
     * beyond the body's bounding radius.
     */
    void sweep(int body, int slot, double dt, double turned) {
        double x = bodies.x[body];
        double y = bodies.y[body];
        bodies.outline[slot].bounds(x, y, bodies.cos[body], bodies.sin[body], swept);
        double radius = bodies.boundingRadius[body];
        swept.minX = Math.max(swept.minX - turned, x - radius);
        swept.minY = Math.max(swept.minY - turned, y - radius);
        swept.maxX = Math.min(swept.maxX + turned, x + radius);
        swept.maxY = Math.min(swept.maxY + turned, y + radius);
        stretch(body, dt);
    }

    /** Sweeps a body's bounding circle for dt seconds, so that turning makes no difference. */
    void sweepAround(int body, double dt) {
        double radius = bodies.boundingRadius[body];
        swept.minX = bodies.x[body] - radius;
        swept.minY = bodies.y[body] - radius;
        swept.maxX = bodies.x[body] + radius;
        swept.maxY = bodies.y[body] + radius;
        stretch(body, dt);
    }

    /**
     * Sweeps the present fixture and all that lies within a reach (m) of a shape whose body is at a
     * pose (m, cosine and sine). For one part of a body that is its own surroundings, not those of
     * the whole body.
     */
    void sweepBeside(int body, int slot, double x, double y, double cos, double sin, double reach) {
        double radius = bodies.boundingRadius[body] + reach;
        swept.minX = x - radius;
        swept.minY = y - radius;
        swept.maxX = x + radius;
        swept.maxY = y + radius;
        if (bodies.nextShapeOf(body) != Pairs.NONE) {
            clipToPart(slot, x, y, cos, sin, reach);
        }
        swept.minX = Math.min(bodies.fixtureMinX[slot], swept.minX);
        swept.minY = Math.min(bodies.fixtureMinY[slot], swept.minY);
        swept.maxX = Math.max(bodies.fixtureMaxX[slot], swept.maxX);
        swept.maxY = Math.max(bodies.fixtureMaxY[slot], swept.maxY);
    }

    private void clipToPart(int slot, double x, double y, double cos, double sin, double reach) {
        bodies.outline[slot].bounds(x, y, cos, sin, part);
        swept.minX = Math.max(swept.minX, part.minX - reach);
        swept.minY = Math.max(swept.minY, part.minY - reach);
        swept.maxX = Math.min(swept.maxX, part.maxX + reach);
        swept.maxY = Math.min(swept.maxY, part.maxY + reach);
    }

    /**
     * Adds an upper bound on the displacement in dt seconds: the one with the acceleration and the
     * one without.
     */
    private void stretch(int body, double dt) {
        double plainX = dt * bodies.velocityX[body];
        double plainY = dt * bodies.velocityY[body];
        double pulledX = plainX + dt * dt * bodies.accelerationX[body] / 2;
        double pulledY = plainY + dt * dt * bodies.accelerationY[body] / 2;
        swept.minX += lesser(lesser(plainX, pulledX), 0);
        swept.minY += lesser(lesser(plainY, pulledY), 0);
        swept.maxX += greater(greater(plainX, pulledX), 0);
        swept.maxY += greater(greater(plainY, pulledY), 0);
    }

    /** Faster than Math.min, which handles signed zeros and takes three times as long. */
    private static double lesser(double a, double b) {
        return a < b ? a : b;
    }

    private static double greater(double a, double b) {
        return a > b ? a : b;
    }

    /** Whether the fixture of a shape holds the swept box. */
    boolean isCovered(int slot) {
        return Signs.none(
                swept.minX - bodies.fixtureMinX[slot],
                swept.minY - bodies.fixtureMinY[slot],
                bodies.fixtureMaxX[slot] - swept.maxX,
                bodies.fixtureMaxY[slot] - swept.maxY);
    }

    /**
     * Whether a fixture is much larger than necessary, so that a body that was fast does not keep
     * neighbours that it can no longer meet.
     */
    boolean isLoose(int body, int slot, double dt) {
        double radius = size(body, slot);
        double aheadX = Math.abs(ahead(bodies.velocityX[body], STEPS_AHEAD * dt, radius));
        double aheadY = Math.abs(ahead(bodies.velocityY[body], STEPS_AHEAD * dt, radius));
        double needed =
                (swept.maxX - swept.minX)
                        + (swept.maxY - swept.minY)
                        + (4 * MARGIN * radius + aheadX + aheadY);
        double laid =
                (bodies.fixtureMaxX[slot] - bodies.fixtureMinX[slot])
                        + (bodies.fixtureMaxY[slot] - bodies.fixtureMinY[slot]);
        return laid > LOOSE * needed;
    }

    /**
     * Writes the fixture of a shape: for a static body the swept box itself, for others with a
     * margin, which is larger ahead.
     */
    void write(int body, int slot, double dt) {
        double radius = size(body, slot);
        double margin = bodies.type[body] == BodyType.STATIC ? 0 : MARGIN * radius;
        boolean isAlone = bodies.firstPair[body] == Pairs.NONE;
        double steps = isAlone ? stepsAheadAlone(body) : STEPS_AHEAD;
        double aheadX = ahead(bodies.velocityX[body], steps * dt, radius);
        double aheadY = ahead(bodies.velocityY[body], steps * dt, radius);
        bodies.fixtureMinX[slot] = swept.minX - margin + Math.min(0, aheadX);
        bodies.fixtureMinY[slot] = swept.minY - margin + Math.min(0, aheadY);
        bodies.fixtureMaxX[slot] = swept.maxX + margin + Math.max(0, aheadX);
        bodies.fixtureMaxY[slot] = swept.maxY + margin + Math.max(0, aheadY);
    }

    /** Length in m to which the margin is proportional; an edge of a chain has its own. */
    private double size(int body, int slot) {
        Outline outline = bodies.outline[slot];
        return outline.isEdge() ? outline.halfLength() : bodies.boundingRadius[body];
    }

    /**
     * Number of steps, pseudo-random by the mantissa bits of the body's position. So it depends on
     * no other body, and neither scaling by a power of two nor mirroring changes it.
     */
    private int stepsAheadAlone(int slot) {
        long bits = SPREAD * digits(bodies.x[slot]);
        bits = SPREAD * (bits + digits(bodies.y[slot]));
        return LEAST_AHEAD_ALONE + (int) (bits >>> Long.SIZE - BITS_AHEAD_ALONE);
    }

    private static long digits(double number) {
        return Double.doubleToRawLongBits(number) & DIGITS;
    }

    /** Displacement in some seconds, limited to {@code most} in either direction, m. */
    private static double ahead(double velocity, double seconds, double most) {
        return Math.max(-most, Math.min(most, seconds * velocity));
    }
}
