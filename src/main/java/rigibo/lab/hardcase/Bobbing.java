package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * Truth, in water of density 1 up to y = 0: a box of height 1 and density ρ floats with its centre
 * at ½ − ρ. While it is partly under water it bobs with ω² = g/ρ. With the width b it rolls with ω²
 * = mg·GM/I about its metacentre, GM = b²/12ρ − (1 − ρ)/2 (Bouguer 1746), to first order in the
 * tilt; the next term is of second order.
 */
final class Bobbing implements Scenes {

    private static final double DENSITY = 0.6;
    private static final double WIDTH = 3;
    private static final double LIFTED = 0.2;
    private static final double TILT = 1e-4;
    private static final double HORIZON = 20;

    @Override
    public void run(Trial trial) {
        trial.variant("bobbing");
        RigidBody[] box = new RigidBody[1];
        WatchedPool pool = water(trial, LIFTED, 0, box);
        double bobbing = Math.sqrt(Trial.GRAVITY / DENSITY);
        while (pool.time() < HORIZON) {
            pool.step();
            double y = 0.5 - DENSITY + LIFTED * Math.cos(bobbing * pool.time());
            trial.measure("height", Math.abs(box[0].y() - y), "m", 1e-9, 1e-6);
        }
        trial.variant("rolling");
        pool = water(trial, 0, TILT, box);
        double metacentre = WIDTH * WIDTH / (12 * DENSITY) - (1 - DENSITY) / 2;
        double rolling = Math.sqrt(12 * Trial.GRAVITY * metacentre / (WIDTH * WIDTH + 1));
        while (pool.time() < HORIZON) {
            pool.step();
            double angle = TILT * Math.cos(rolling * pool.time());
            trial.measure("tilt", Math.abs(box[0].angle() - angle) / TILT, "of tilt", 1e-6);
        }
    }

    private static WatchedPool water(Trial trial, double up, double angle, RigidBody[] box) {
        WatchedPool pool =
                trial.pool(
                        Effects.of(
                                new Gravity(0, -Trial.GRAVITY),
                                new Rotation(),
                                new Buoyancy(0, 1, 0)));
        BodyDefinition raft = Solid.box(WIDTH, 1).material(Solid.matter(0, 0).density(DENSITY));
        box[0] = pool.add(raft.at(0, 0.5 - DENSITY + up).angle(angle));
        return pool;
    }
}
