package rigibo.lab.bench.query;

import java.util.Random;

/** The directions of rays, which begin at random points of a square. */
enum Rays {
    /** To the right. */
    LEVEL("level") {
        @Override
        void aim(Random random, double[] ray, int at) {
            ray[at + 2] = ray[at] + LENGTH;
            ray[at + 3] = ray[at + 1];
        }
    },
    /** To the right and up, where the bounds of a ray are largest. */
    DIAGONAL("diagonal") {
        @Override
        void aim(Random random, double[] ray, int at) {
            ray[at + 2] = ray[at] + LENGTH * Math.sqrt(0.5);
            ray[at + 3] = ray[at + 1] + LENGTH * Math.sqrt(0.5);
        }
    },
    /** In a random direction. */
    RANDOM("random") {
        @Override
        void aim(Random random, double[] ray, int at) {
            double angle = 2 * Math.PI * random.nextDouble();
            ray[at + 2] = ray[at] + LENGTH * Math.cos(angle);
            ray[at + 3] = ray[at + 1] + LENGTH * Math.sin(angle);
        }
    };

    /** The numbers of a ray: x and y of its start and of its end, m. */
    static final int STRIDE = 4;

    /** The length of a ray that hits nothing, m. */
    private static final double LENGTH = 100;

    final String words;

    Rays(String words) {
        this.words = words;
    }

    /** Writes the end of a ray whose start is written. */
    abstract void aim(Random random, double[] ray, int at);

    /** Draws rays that start within a square about the origin. */
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
