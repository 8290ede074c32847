package rigibo.backend.impact;

import java.util.Random;

/** Impacts for tests: from a few numbers, or anything from a seed. */
final class Meet {

    private Meet() {}

    /** A 1 kg body B that meets a wall to its left, which nothing moves; no points yet. */
    static Impact wall(double velocityX, double velocityY, double spin, double inertia) {
        Impact impact = new Impact();
        impact.normalX = 1;
        impact.inverseMassB = 1;
        impact.inverseInertiaB = 1 / inertia;
        impact.velocityBX = velocityX;
        impact.velocityBY = velocityY;
        impact.spinB = spin;
        return impact;
    }

    /** Bodies of 0.1 to 10 kg, one in four of them fixed, that meet at a point 1 m round each. */
    static Impact any(Random random, int points) {
        Impact impact = new Impact();
        double angle = between(random, -Math.PI, Math.PI);
        impact.normalX = Math.cos(angle);
        impact.normalY = Math.sin(angle);
        impact.friction = random.nextInt(4) == 0 ? 0 : between(random, 0, 1.5);
        impact.elasticity = random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble();
        impact.surfaceSpeed = random.nextInt(4) == 0 ? between(random, -1, 1) : 0;
        int fixed = random.nextInt(8);
        if (fixed != 0) {
            impact.inverseMassA = Math.pow(10, between(random, -1, 1));
            impact.inverseInertiaA = impact.inverseMassA * between(random, 0.5, 8);
        }
        if (fixed != 1) {
            impact.inverseMassB = Math.pow(10, between(random, -1, 1));
            impact.inverseInertiaB = impact.inverseMassB * between(random, 0.5, 8);
        }
        impact.velocityAX = between(random, -2, 2);
        impact.velocityAY = between(random, -2, 2);
        impact.spinA = between(random, -3, 3);
        impact.velocityBX = between(random, -2, 2);
        impact.velocityBY = between(random, -2, 2);
        impact.spinB = between(random, -3, 3);
        place(random, impact, points);
        return impact;
    }

    /** Two bodies that meet along the axes, B to the right of A. */
    static Impact level(Random random, int points) {
        Impact impact = any(random, points);
        impact.normalX = 1;
        impact.normalY = 0;
        impact.points = 0;
        place(random, impact, points);
        return impact;
    }

    /** Two points lie on one face, across the normal, and no nearer than 0.2 m. */
    private static void place(Random random, Impact impact, int points) {
        double x = between(random, -1, 1);
        double y = between(random, -1, 1);
        double bx = x + between(random, -1, 1);
        double by = y + between(random, -1, 1);
        impact.addPoint(0, 0, x, y, bx, by);
        if (points == 2) {
            double apart = between(random, 0.2, 2);
            impact.addPoint(-apart * impact.normalY, apart * impact.normalX, x, y, bx, by);
        }
    }

    /** Takes the drive from what is fixed, which would put energy in. */
    static void haltFixed(Impact impact) {
        if (impact.inverseMassA == 0) {
            impact.velocityAX = 0;
            impact.velocityAY = 0;
            impact.spinA = 0;
        }
        if (impact.inverseMassB == 0) {
            impact.velocityBX = 0;
            impact.velocityBY = 0;
            impact.spinB = 0;
        }
    }

    /** A copy of an impact in which no body moves and no surface runs. */
    static Impact stopped(Impact impact) {
        Impact stopped = copy(impact);
        stopped.velocityAX = 0;
        stopped.velocityAY = 0;
        stopped.spinA = 0;
        stopped.velocityBX = 0;
        stopped.velocityBY = 0;
        stopped.spinB = 0;
        stopped.surfaceSpeed = 0;
        return stopped;
    }

    static double between(Random random, double least, double most) {
        return least + random.nextDouble() * (most - least);
    }

    static Impact copy(Impact impact) {
        Impact copy = new Impact();
        copy.normalX = impact.normalX;
        copy.normalY = impact.normalY;
        copy.points = impact.points;
        for (int i = 0; i < impact.points; i++) {
            copy.armAX[i] = impact.armAX[i];
            copy.armAY[i] = impact.armAY[i];
            copy.armBX[i] = impact.armBX[i];
            copy.armBY[i] = impact.armBY[i];
        }
        copy.inverseMassA = impact.inverseMassA;
        copy.inverseInertiaA = impact.inverseInertiaA;
        copy.inverseMassB = impact.inverseMassB;
        copy.inverseInertiaB = impact.inverseInertiaB;
        copy.velocityAX = impact.velocityAX;
        copy.velocityAY = impact.velocityAY;
        copy.spinA = impact.spinA;
        copy.velocityBX = impact.velocityBX;
        copy.velocityBY = impact.velocityBY;
        copy.spinB = impact.spinB;
        copy.surfaceSpeed = impact.surfaceSpeed;
        copy.friction = impact.friction;
        copy.elasticity = impact.elasticity;
        return copy;
    }
}
