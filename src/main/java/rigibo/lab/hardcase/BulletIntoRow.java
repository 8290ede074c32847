package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A disc of up to 10⁴ times a box's mass flies at up to 2,000 m/s into a row of up to five boxes
 * that lean on a wall of 1 mm to 1 m. Truth: nothing passes through the wall or the floor, and the
 * disc passes through no box; bodies may go over the wall. Where nothing can give way, the boxes
 * overlap, and the engine reports it.
 *
 * @param leastRatio the least mass of the disc, as a multiple of a box's
 * @param leastSpeed its least speed, m/s
 * @param leastBoxes the least number of boxes
 */
record BulletIntoRow(double leastRatio, double leastSpeed, int leastBoxes) implements Scenes {

    /** Bullets of any mass and speed into any row. */
    static final BulletIntoRow ANY = new BulletIntoRow(1, 50, 1);

    /** Heavy and fast bullets into long rows: those that are hardest to stop. */
    static final BulletIntoRow HARDEST = new BulletIntoRow(1000, 400, 4);

    private static final int FEW = 100;
    private static final int ALL = 4000;
    private static final int MOST_BOXES = 5;
    private static final int STEPS = 30;
    private static final double WALL_HEIGHT = 20;

    /** The overlap with fixed bodies that is allowed, in widths of the body. */
    private static final double MOST_INTO_FIXED = 0.02;

    /** The overlap from which on the engine reports crushing, in widths of the body. */
    private static final double CRUSHED = 0.05;

    @Override
    public void run(Trial trial) {
        int count = trial.sampling().count(FEW, ALL);
        double[] failed = new double[4];
        for (int i = 0; i < count; i++) {
            trial.variant("seed " + trial.sampling().seed() + ", bullet " + i);
            Shot shot = new Shot(trial, this, trial.sampling().random(i));
            shot.fly();
            failed[0] += shot.isThroughFixed ? 1 : 0;
            failed[1] += shot.isThroughBox ? 1 : 0;
            failed[2] += shot.deepest > MOST_INTO_FIXED ? 1 : 0;
            failed[3] += shot.isDeep && !shot.isTold ? 1 : 0;
            trial.measure("deepest in wall or floor", shot.deepest, "width", Limits.NONE);
        }
        String of = "of " + count;
        Limits none = Limits.same(0);
        trial.measure("through wall or floor", failed[0], of, none);
        trial.measure("bullet through a box", failed[1], of, none);
        trial.measure("2 % in wall or floor", failed[2], of, none);
        trial.measure("crushed and not told", failed[3], of, none);
    }

    /** One bullet. The wall's near face is x = 0, the floor y = 0. */
    private static final class Shot {

        private final WatchedPool pool;
        private final List<RigidBody> boxes = new ArrayList<>();
        private final RigidBody bullet;
        private final double thickness;
        private boolean isThroughFixed;
        private boolean isThroughBox;
        private boolean isDeep;
        private boolean isTold;
        private double deepest;

        Shot(Trial trial, BulletIntoRow least, SplittableRandom random) {
            Material matter = Solid.matter(0.5, 0.5 * random.nextDouble());
            thickness = between(random, 1e-3, 1);
            pool = trial.earth().withOverlapOfItsOwn();
            pool.add(Solid.fixed(8000, 2).at(0, -1).material(matter));
            pool.add(
                    Solid.fixed(thickness, WALL_HEIGHT)
                            .at(thickness / 2, WALL_HEIGHT / 2)
                            .material(matter));
            int count = least.leastBoxes + random.nextInt(MOST_BOXES - least.leastBoxes + 1);
            BodyDefinition box = Solid.box(1, 1).material(matter);
            for (int i = 0; i < count; i++) {
                boxes.add(pool.add(box.at(-0.5 - i, 0.5)));
            }
            double radius = 0.1 + 0.3 * random.nextDouble();
            bullet =
                    pool.add(
                            Solid.disc(radius)
                                    .at(
                                            -count - radius - 0.01 - 3 * random.nextDouble(),
                                            radius
                                                    + 0.01
                                                    + (0.98 - 2 * radius) * random.nextDouble())
                                    .velocity(between(random, least.leastSpeed, 2000), 0)
                                    .mass(
                                            between(random, least.leastRatio, 1e4)
                                                    * boxes.get(0).mass())
                                    .material(matter));
        }

        void fly() {
            for (int step = 0; step < STEPS; step++) {
                List<double[]> before = places();
                isTold |= pool.step().crushed() > 0;
                isDeep |= pool.overlapNow() > CRUSHED;
                judge(before, places());
            }
        }

        private List<double[]> places() {
            List<double[]> places = new ArrayList<>();
            places.add(new double[] {bullet.x(), bullet.y()});
            boxes.forEach(box -> places.add(new double[] {box.x(), box.y()}));
            return places;
        }

        private void judge(List<double[]> before, List<double[]> after) {
            for (int i = 0; i < before.size(); i++) {
                double[] from = before.get(i);
                double[] to = after.get(i);
                boolean isBelowTop = from[1] < WALL_HEIGHT && to[1] < WALL_HEIGHT;
                isThroughFixed |= isBelowTop && from[0] < thickness && to[0] > thickness;
                isThroughFixed |= to[1] < 0;
                isThroughBox |= i > 0 && isPassed(before.get(0), from, after.get(0), to);
                deepest = Math.max(deepest, intoFixed(i == 0 ? bullet : boxes.get(i - 1)));
            }
        }

        /** Whether the bullet went from the left of a box to its right, beside it both times. */
        private boolean isPassed(double[] was, double[] boxWas, double[] is, double[] boxIs) {
            double beside = 0.5 + bullet.shape().boundingRadius();
            return was[0] < boxWas[0]
                    && is[0] > boxIs[0]
                    && Math.abs(was[1] - boxWas[1]) < beside
                    && Math.abs(is[1] - boxIs[1]) < beside;
        }

        /** Depth of a body in the near face of the wall or in the floor, in its widths. */
        private double intoFixed(RigidBody body) {
            Aabb bounds = new Aabb();
            double cos = Math.cos(body.angle());
            double sin = Math.sin(body.angle());
            body.shape().bounds(body.x(), body.y(), cos, sin, bounds);
            boolean isBefore = body.x() < 0 && bounds.maxY < WALL_HEIGHT;
            double deep = Math.max(-bounds.minY, isBefore ? bounds.maxX : 0);
            return Math.max(0, deep) / body.shape().smallestWidth();
        }

        /** A number whose logarithm is uniform, so that light and heavy are equally frequent. */
        private static double between(SplittableRandom random, double least, double most) {
            return least * Math.pow(most / least, random.nextDouble());
        }
    }
}
