package rigibo.backend.broadphase;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Outline;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/**
 * How large size fixtures are. A fixture holds what a shape sweeps in the step to come and a margin
 * round it, so that it need not be laid in every step. One shape is swept at a time; what is asked
 * and written next is about that one.
 */
final class SizeFixtures {

    /**
     * Margin round a fixture as a share of the body's bounding radius: fewer refits, more pairs.
     */
    private static final double MARGIN = 0.1;

    /**
     * Steps to come that a fixture is laid ahead for, up to one radius: a body in motion then keeps
     * its fixture for some steps instead of leaving its margin in each.
     */
    private static final double STEPS_AHEAD = 3;

    /**
     * Steps ahead for a body that has no neighbours, at least: it seldom meets any, and if it does
     * its fixture is laid anew. Some look farther ahead than others: bodies that were thrown alike
     * would else all leave their fixtures in one step.
     */
    private static final int LEAST_AHEAD_ALONE = 8;

    private static final int BITS_AHEAD_ALONE = 4;

    /** The golden ratio's multiples spread what lies close together, as in a hash table. */
    private static final long SPREAD = 0x9E3779B97F4A7C15L;

    /** The bits of a double that are neither its sign nor its power of two. */
    private static final long DIGITS = (1L << 52) - 1;

    /** A fixture that is larger than it would be laid now by this factor is laid anew. */
    private static final double LOOSE = 1.25;

    private final Bodies bodies;

    /** What the shape in hand sweeps. */
    private final Aabb swept = new Aabb();

    private final Aabb part = new Aabb();

    SizeFixtures(Bodies bodies) {
        this.bodies = bodies;
    }

    /** How far in m turning may move the outline in dt seconds. */
    double turned(int body, double dt) {
        return Math.abs(bodies.spin[body]) * dt * bodies.sweepRadius[body];
    }

    /**
     * Bounds over the way of the next dt seconds; a body that turns may reach as far as its radius.
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

    /** Bounds over that way of a body's bounding circle: it may turn as it likes. */
    void sweepAround(int body, double dt) {
        double radius = bodies.boundingRadius[body];
        swept.minX = bodies.x[body] - radius;
        swept.minY = bodies.y[body] - radius;
        swept.maxX = bodies.x[body] + radius;
        swept.maxY = bodies.y[body] + radius;
        stretch(body, dt);
    }

    /**
     * Bounds of the fixture there is and of all within a reach (m) of a shape whose body is at a
     * pose (m, cosine and sine): of a part what is near itself, not all that is near the body.
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

    /** Adds a bound on the way in dt seconds: with the acceleration, and without. */
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

    /** Math.min would take care of signed zeros, which takes it thrice as long. */
    private static double lesser(double a, double b) {
        return a < b ? a : b;
    }

    private static double greater(double a, double b) {
        return a > b ? a : b;
    }

    /** Whether the fixture of a shape holds what the shape sweeps. */
    boolean isCovered(int slot) {
        return swept.minX >= bodies.fixtureMinX[slot]
                && swept.minY >= bodies.fixtureMinY[slot]
                && swept.maxX <= bodies.fixtureMaxX[slot]
                && swept.maxY <= bodies.fixtureMaxY[slot];
    }

    /**
     * Whether a fixture is much larger than it needs to be: a body that was fast keeps no
     * neighbours that it cannot meet any more.
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
     * Writes the fixture of a shape. Of a static body it is what the shape sweeps; others have a
     * margin, and more of it ahead.
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

    /** What the margin is a share of, m: an edge of a chain has one of its own. */
    private double size(int body, int slot) {
        Outline outline = bodies.outline[slot];
        return outline.isEdge() ? outline.halfLength() : bodies.boundingRadius[body];
    }

    /**
     * At random, as it were, by the digits of where the body is: no other body has a part in it,
     * and neither has the scale or the side of a mirror, which are not in the digits.
     */
    private int stepsAheadAlone(int slot) {
        long bits = SPREAD * digits(bodies.x[slot]);
        bits = SPREAD * (bits + digits(bodies.y[slot]));
        return LEAST_AHEAD_ALONE + (int) (bits >>> Long.SIZE - BITS_AHEAD_ALONE);
    }

    private static long digits(double number) {
        return Double.doubleToRawLongBits(number) & DIGITS;
    }

    /** The way in some seconds, up to a most either way, m. */
    private static double ahead(double velocity, double seconds, double most) {
        return Math.max(-most, Math.min(most, seconds * velocity));
    }
}
