package rigibo.lab.hardcase;

import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/**
 * J16: joined bodies depend on nothing but the scene. A chain of bars with limits, a motor, a
 * spring and a weight keeps its bits when it is mirrored, 64 times as large under 64 times the
 * gravity, beside strangers, and restored from a snapshot within a swing. It stays equal to
 * round-off in any order of its bodies and joints, and in a frame that moves.
 */
final class JointLaws {

    private static final double SCALE = 64;
    private static final int LINKS = 6;
    private static final double HORIZON = 2;

    /** The difference allowed: orders and frames change only rounding, which a chain amplifies. */
    private static final double ROUND_OFF = 1e-6;

    private JointLaws() {}

    /** A chain, as it is stated to a pool. */
    private record Chain(double side, double scale, double carried, long order, double[] draws) {

        Chain mirrored() {
            return new Chain(-side, scale, carried, order, draws);
        }

        Chain scaled() {
            return new Chain(side, SCALE, carried, order, draws);
        }

        Chain carriedAt(double speed) {
            return new Chain(side, scale, speed, order, draws);
        }

        Chain inOrder(long other) {
            return new Chain(side, scale, carried, other, draws);
        }

        List<RigidBody> build(WatchedPool pool) {
            List<Integer> order = new ArrayList<>(range());
            if (this.order != 0) {
                Collections.shuffle(order, new Random(this.order));
            }
            RigidBody[] links = new RigidBody[LINKS + 1];
            for (int i : order) {
                links[i] = pool.add(link(i));
            }
            Collections.reverse(order);
            for (int i : this.order == 0 ? range() : order) {
                if (i > 0) {
                    pool.join(joint(i, links[i - 1], links[i]));
                }
            }
            return List.of(links);
        }

        private static List<Integer> range() {
            return IntStream.rangeClosed(0, LINKS).boxed().toList();
        }

        private BodyDefinition link(int i) {
            if (i == 0) {
                BodyDefinition hook = BodyDefinition.kinematic(new Circle(0.05 * scale));
                return hook.velocity(carried, 0).group(1);
            }
            double length = 0.3 * scale;
            return Solid.box(length, (0.05 + 0.1 * draws[i]) * scale)
                    .at(side * (i - 0.5) * length, 0)
                    .velocity(carried, 0)
                    .group(1);
        }

        /** The third bends on a spring and the fourth within limits; the second is braked. */
        private JointDefinition joint(int i, RigidBody before, RigidBody here) {
            JointDefinition hinge = RevoluteJoint.at(before, here, side * (i - 1) * 0.3 * scale, 0);
            double torque = scale * scale * scale * scale;
            return switch (i) {
                case 2 -> hinge.motor(0, 0.01 * torque);
                case 3 -> hinge.spring(2, 0.2);
                case 4 -> hinge.limits(-0.5, 0.5);
                default -> hinge;
            };
        }

        WatchedPool pool(Trial trial) {
            return trial.pool(
                            Earth.space()
                                    .with(new Joints())
                                    .with(new Gravity(0, -Trial.GRAVITY * scale)))
                    .withEnergyOfItsOwn();
        }

        /** The final places of the links, in the frame and scale of the plain chain. */
        double[] run(Trial trial) {
            WatchedPool pool = pool(trial);
            List<RigidBody> links = build(pool);
            pool.run(HORIZON);
            return places(links, pool.time());
        }

        double[] places(List<RigidBody> links, double time) {
            double[] places = new double[3 * links.size()];
            for (int i = 0; i < links.size(); i++) {
                places[3 * i] = side * (links.get(i).x() - carried * time) / scale;
                places[3 * i + 1] = links.get(i).y() / scale;
                places[3 * i + 2] = side * links.get(i).angle();
            }
            return places;
        }
    }

    static void run(Trial trial) {
        int count = trial.sampling().count(2, 20);
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double[] draws = random.doubles(LINKS + 1).toArray();
            trial.variant("draw " + i);
            Chain chain = new Chain(1, 1, 0, 0, draws);
            double[] truth = chain.run(trial);
            same(trial, "mirrored", truth, chain.mirrored().run(trial), 0);
            same(trial, "64 times as large", truth, chain.scaled().run(trial), 0);
            same(trial, "in another order", truth, chain.inOrder(i + 1).run(trial), ROUND_OFF);
            same(trial, "carried along", truth, chain.carriedAt(3).run(trial), ROUND_OFF);
            same(trial, "beside strangers", truth, besideStrangers(trial, chain), 0);
            same(trial, "from a snapshot", truth, fromSnapshot(trial, chain), 0);
            edit(trial, chain);
        }
    }

    private static void same(
            Trial trial, String how, double[] truth, double[] places, double most) {
        trial.measure("off " + how, Places.farthestApart(truth, places), "m, rad", most);
    }

    private static double[] besideStrangers(Trial trial, Chain chain) {
        WatchedPool pool = chain.pool(trial);
        RigidBody far = pool.add(BodyDefinition.fixed(new Circle(0.1)).at(50, 0));
        RigidBody bob = pool.add(Solid.disc(0.3).at(51, 0));
        pool.join(RevoluteJoint.at(far, bob, 50, 0));
        List<RigidBody> links = chain.build(pool);
        pool.run(HORIZON);
        return chain.places(links, pool.time());
    }

    private static double[] fromSnapshot(Trial trial, Chain chain) {
        WatchedPool pool = chain.pool(trial);
        chain.build(pool);
        pool.run(HORIZON / 2);
        Pool again = Pool.restore(pool.pool().snapshot());
        while (again.time() < HORIZON - Trial.DT / 2) {
            again.step(Trial.DT);
        }
        return chain.places(again.bodies(), again.time());
    }

    /** Welds, gears and cuts joints while it swings: joints hold, no energy is gained. */
    private static void edit(Trial trial, Chain chain) {
        WatchedPool pool = chain.pool(trial);
        List<RigidBody> links = chain.build(pool);
        pool.run(0.5);
        RigidBody last = links.get(LINKS);
        Joint cut = last.joints().get(0);
        Joint third = links.get(3).joints().get(0);
        pool.join(GearJoint.of(third, cut, 1));
        pool.run(0.3);
        double error = pool.jointError();
        pool.pool().remove(cut);
        pool.join(WeldJoint.at(links.get(LINKS - 1), last, last.x(), last.y()));
        RigidBody hook = links.get(0);
        RigidBody rider = pool.add(Solid.disc(0.1).at(5, 0).group(1));
        pool.join(PrismaticJoint.along(hook, rider, 5, 0, 0.3));
        double start = pool.energy();
        double gained = 0;
        while (pool.time() < HORIZON) {
            pool.step();
            gained = Math.max(gained, pool.energy() - start);
            error = Math.max(error, pool.jointError());
        }
        trial.measure("error after edits", error, "m", JointLimits.ERROR);
        double all = Math.abs(start) + rider.mass() * Trial.GRAVITY;
        trial.measure("energy gained after edits", gained / all, "", Limits.of(1e-3, 1e-6));
    }
}
