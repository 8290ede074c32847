package rigibo.backend.impact;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/**
 * An impact between two bodies A and B: what goes into it, and what comes out. A plain carrier that
 * its owner reuses; velocities are those at the time of the impact, and are changed by it.
 */
public final class Impact {

    /** Unit normal from A to B. */
    public double normalX;

    public double normalY;

    /** Number of points that touch, 1 or 2. */
    public int points;

    /** World vectors from each body's centre of mass to the points, m. */
    public final double[] armAX = new double[2];

    public final double[] armAY = new double[2];
    public final double[] armBX = new double[2];
    public final double[] armBY = new double[2];

    /** Inverse masses, 1/kg, and inverse inertias, 1/(kg·m²); 0 for what impulses cannot move. */
    public double inverseMassA;

    public double inverseInertiaA;
    public double inverseMassB;
    public double inverseInertiaB;

    /** Velocities, m/s, and spins, rad/s; resolving the impact changes them. */
    public double velocityAX;

    public double velocityAY;
    public double spinA;
    public double velocityBX;
    public double velocityBY;
    public double spinB;

    /** Sum of both running surfaces' speeds along the tangent, m/s; 0 if no surface runs. */
    public double surfaceSpeed;

    /** Friction coefficient of the pair, mixed from both materials. */
    public double friction;

    /** Elasticity of the pair, mixed from both materials, 0 to 1. */
    public double elasticity;

    /** Result, N·s: impulse along the normal at each point, and total along (−ny, nx). */
    public final double[] normalImpulse = new double[2];

    public double tangentImpulse;

    /**
     * Loads masses, velocities and materials of a pair from the columns; {@link #addPoint} follows.
     */
    public void load(Bodies bodies, Pairs pairs, int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        normalX = pairs.normalX[pair];
        normalY = pairs.normalY[pair];
        friction = pairs.frictionOf(pair);
        elasticity = pairs.elasticityOf(pair);
        surfaceSpeed = bodies.surfaceSpeed == null ? 0 : pairs.surfaceSpeed(bodies, pair);
        points = 0;
        inverseMassA = bodies.inverseMass[a];
        inverseInertiaA = bodies.inverseInertiaOf(a);
        inverseMassB = bodies.inverseMass[b];
        inverseInertiaB = bodies.inverseInertiaOf(b);
        velocityAX = bodies.velocityX[a];
        velocityAY = bodies.velocityY[a];
        spinA = bodies.spinOf(a);
        velocityBX = bodies.velocityX[b];
        velocityBY = bodies.velocityY[b];
        spinB = bodies.spinOf(b);
    }

    /**
     * Adds a point at (x, y); the bodies' centres of mass are at (ax, ay) and (bx, by), all in m.
     */
    public void addPoint(double x, double y, double ax, double ay, double bx, double by) {
        armAX[points] = x - ax;
        armAY[points] = y - ay;
        armBX[points] = x - bx;
        armBY[points] = y - by;
        points++;
    }

    /** Writes the velocities of movable bodies back into the columns. */
    public void store(Bodies bodies, Pairs pairs, int pair) {
        store(bodies, pairs.bodyA[pair], velocityAX, velocityAY, spinA);
        store(bodies, pairs.bodyB[pair], velocityBX, velocityBY, spinB);
    }

    /** Skips immovable bodies: an infinite impulse would give them 0·∞ = NaN. */
    private static void store(Bodies bodies, int slot, double vx, double vy, double spin) {
        if (!bodies.isDynamic(slot)) {
            return;
        }
        bodies.velocityX[slot] = vx;
        bodies.velocityY[slot] = vy;
        if (bodies.turns()) {
            bodies.spin[slot] = spin;
        }
    }

    /** Parting speed at a point, m/s; negative when the bodies close. */
    double parting(int i) {
        double vx = velocityBX - spinB * armBY[i] - velocityAX + spinA * armAY[i];
        double vy = velocityBY + spinB * armBX[i] - velocityAY - spinA * armAX[i];
        return vx * normalX + vy * normalY;
    }

    /** Least parting speed of all points, m/s. */
    public double slowestParting() {
        return points == 1 ? parting(0) : Math.min(parting(0), parting(1));
    }

    /** Sum of the normal impulses of all points, N·s. */
    public double totalNormalImpulse() {
        return points == 1 ? normalImpulse[0] : normalImpulse[0] + normalImpulse[1];
    }

    /** Drops one of two points. */
    void keepOnly(int i) {
        armAX[0] = armAX[i];
        armAY[0] = armAY[i];
        armBX[0] = armBX[i];
        armBY[0] = armBY[i];
        points = 1;
    }
}
