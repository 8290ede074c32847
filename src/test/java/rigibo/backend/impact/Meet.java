package rigibo.backend.impact;

import java.util.Random;

/** Impacts for tests: from a few numbers, or anything from a seed. */
final class Meet {

    private Meet() {}

    /** A 1 kg body B that meets a wall to its left, which nothing moves; no points yet. */
    static Impact wall(double velocityX, double velocityY, double spin, double inertia) {
        Impact blow = new Impact();
        blow.normalX = 1;
        blow.inverseMassB = 1;
        blow.inverseInertiaB = 1 / inertia;
        blow.velocityBX = velocityX;
        blow.velocityBY = velocityY;
        blow.spinB = spin;
        return blow;
    }

    /** Bodies of 0.1 to 10 kg, one in four of them fixed, that meet at a point 1 m round each. */
    static Impact any(Random random, int points) {
        Impact blow = new Impact();
        double angle = between(random, -Math.PI, Math.PI);
        blow.normalX = Math.cos(angle);
        blow.normalY = Math.sin(angle);
        blow.friction = random.nextInt(4) == 0 ? 0 : between(random, 0, 1.5);
        blow.elasticity = random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble();
        blow.surfaceSpeed = random.nextInt(4) == 0 ? between(random, -1, 1) : 0;
        int fixed = random.nextInt(8);
        if (fixed != 0) {
            blow.inverseMassA = Math.pow(10, between(random, -1, 1));
            blow.inverseInertiaA = blow.inverseMassA * between(random, 0.5, 8);
        }
        if (fixed != 1) {
            blow.inverseMassB = Math.pow(10, between(random, -1, 1));
            blow.inverseInertiaB = blow.inverseMassB * between(random, 0.5, 8);
        }
        blow.velocityAX = between(random, -2, 2);
        blow.velocityAY = between(random, -2, 2);
        blow.spinA = between(random, -3, 3);
        blow.velocityBX = between(random, -2, 2);
        blow.velocityBY = between(random, -2, 2);
        blow.spinB = between(random, -3, 3);
        place(random, blow, points);
        return blow;
    }

    /** Two bodies that meet along the axes, B to the right of A. */
    static Impact level(Random random, int points) {
        Impact blow = any(random, points);
        blow.normalX = 1;
        blow.normalY = 0;
        blow.points = 0;
        place(random, blow, points);
        return blow;
    }

    /** Two points lie on one face, across the normal, and no nearer than 0.2 m. */
    private static void place(Random random, Impact blow, int points) {
        double x = between(random, -1, 1);
        double y = between(random, -1, 1);
        double bx = x + between(random, -1, 1);
        double by = y + between(random, -1, 1);
        blow.addPoint(0, 0, x, y, bx, by);
        if (points == 2) {
            double apart = between(random, 0.2, 2);
            blow.addPoint(-apart * blow.normalY, apart * blow.normalX, x, y, bx, by);
        }
    }

    /** Takes the drive from what is fixed, which would put energy in. */
    static void haltFixed(Impact blow) {
        if (blow.inverseMassA == 0) {
            blow.velocityAX = 0;
            blow.velocityAY = 0;
            blow.spinA = 0;
        }
        if (blow.inverseMassB == 0) {
            blow.velocityBX = 0;
            blow.velocityBY = 0;
            blow.spinB = 0;
        }
    }

    /** A copy of a blow in which no body moves and no surface runs. */
    static Impact stopped(Impact blow) {
        Impact stopped = copy(blow);
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

    static Impact copy(Impact blow) {
        Impact copy = new Impact();
        copy.normalX = blow.normalX;
        copy.normalY = blow.normalY;
        copy.points = blow.points;
        for (int i = 0; i < blow.points; i++) {
            copy.armAX[i] = blow.armAX[i];
            copy.armAY[i] = blow.armAY[i];
            copy.armBX[i] = blow.armBX[i];
            copy.armBY[i] = blow.armBY[i];
        }
        copy.inverseMassA = blow.inverseMassA;
        copy.inverseInertiaA = blow.inverseInertiaA;
        copy.inverseMassB = blow.inverseMassB;
        copy.inverseInertiaB = blow.inverseInertiaB;
        copy.velocityAX = blow.velocityAX;
        copy.velocityAY = blow.velocityAY;
        copy.spinA = blow.spinA;
        copy.velocityBX = blow.velocityBX;
        copy.velocityBY = blow.velocityBY;
        copy.spinB = blow.spinB;
        copy.surfaceSpeed = blow.surfaceSpeed;
        copy.friction = blow.friction;
        copy.elasticity = blow.elasticity;
        return copy;
    }
}
