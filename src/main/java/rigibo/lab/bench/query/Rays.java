package rigibo.lab.bench.query;

import java.util.Random;

/** The ways that rays go, all of them from random points of a square. */
enum Rays {
    /** To the right. */
    LEVEL("level") {
        @Override
        void aim(Random random, double[] ray, int at) {
            ray[at + 2] = ray[at] + LENGTH;
            ray[at + 3] = ray[at + 1];
        }
    },
    /** To the right and up, where the box round a ray is largest. */
    DIAGONAL("diagonal") {
        @Override
        void aim(Random random, double[] ray, int at) {
            ray[at + 2] = ray[at] + LENGTH * Math.sqrt(0.5);
            ray[at + 3] = ray[at + 1] + LENGTH * Math.sqrt(0.5);
        }
    },
    /** Any way. */
    RANDOM("random") {
        @Override
        void aim(Random random, double[] ray, int at) {
            double angle = 2 * Math.PI * random.nextDouble();
            ray[at + 2] = ray[at] + LENGTH * Math.cos(angle);
            ray[at + 3] = ray[at + 1] + LENGTH * Math.sin(angle);
        }
    };

    /** Numbers of a ray: where it begins and where it ends, x and y, m. */
    static final int STRIDE = 4;

    /** Of a ray that meets nobody, m. */
    private static final double LENGTH = 100;

    final String words;

    Rays(String words) {
        this.words = words;
    }

    /** Ends a ray whose beginning is written. */
    abstract void aim(Random random, double[] ray, int at);

    /** So many rays from points of a square of so many m about the origin. */
    double[] draw(long seed, int count, double square) {
        Random random = new Random(seed);
        double[] rays = new double[STRIDE * count];
        for (int at = 0; at < rays.length; at += STRIDE) {
            rays[at] = (random.nextDouble() - 0.5) * square;
            rays[at + 1] = (random.nextDouble() - 0.5) * square;
            aim(random, rays, at);
        }
        return rays;
    }
}
