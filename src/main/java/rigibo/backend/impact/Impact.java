package rigibo.backend.impact;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/**
 * An impact between two bodies A and B: what goes into it, and what comes out. A plain carrier that
 * its owner reuses; velocities are those at the time of the impact, and are changed by it.
 */
public final class Impact {

    /** Unit normal from A to B, and how many points touch, 1 or 2. */
    public double normalX;

    public double normalY;
    public int points;

    /** From a body's centre of mass to the points, m. */
    public final double[] armAX = new double[2];

    public final double[] armAY = new double[2];
    public final double[] armBX = new double[2];
    public final double[] armBY = new double[2];

    /** 1/kg and 1/(kg·m²), 0 for what cannot be moved or turned. */
    public double inverseMassA;

    public double inverseInertiaA;
    public double inverseMassB;
    public double inverseInertiaB;

    /** m/s and rad/s. */
    public double velocityAX;

    public double velocityAY;
    public double spinA;
    public double velocityBX;
    public double velocityBY;
    public double spinB;

    /** Speed in m/s at which B is carried along the tangent on A; 0 where nothing carries. */
    public double surfaceSpeed;

    /** Mixed for the pair. */
    public double friction;

    public double elasticity;

    /** Result, N·s: along the normal at each point, and along the tangent (−ny, nx) in all. */
    public final double[] normalImpulse = new double[2];

    public double tangentImpulse;

    /** Takes masses, velocities and materials of a pair from the columns; points come apart. */
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

    /** Adds a point at (x, y) in m, of bodies whose centres of mass are where is said, m. */
    public void addPoint(double x, double y, double ax, double ay, double bx, double by) {
        armAX[points] = x - ax;
        armAY[points] = y - ay;
        armBX[points] = x - bx;
        armBY[points] = y - by;
        points++;
    }

    /** Writes the velocities of what can be moved back into the columns. */
    public void store(Bodies bodies, Pairs pairs, int pair) {
        store(bodies, pairs.bodyA[pair], velocityAX, velocityAY, spinA);
        store(bodies, pairs.bodyB[pair], velocityBX, velocityBY, spinB);
    }

    /** An impulse beyond all bounds gives even what has no inverse mass a velocity: 0·∞. */
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

    /** Speed in m/s at which the bodies part at a point; negative when they close. */
    double parting(int i) {
        double vx = velocityBX - spinB * armBY[i] - velocityAX + spinA * armAY[i];
        double vy = velocityBY + spinB * armBX[i] - velocityAY - spinA * armAX[i];
        return vx * normalX + vy * normalY;
    }

    /** The slowest parting over the points, m/s. */
    public double slowestParting() {
        return points == 1 ? parting(0) : Math.min(parting(0), parting(1));
    }

    /** Normal impulse over all points, N·s. */
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
