package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * Truth for v = (3, −4), r = ½, e = ½, per mass: jn = (1 + e)·4 = 6. The contact point's slip 3 is
 * stopped by jt = 3/kt with kt = 1 + r²/(r²/2) = 3, so jt = 1. It sticks where μ·jn ≥ 1: at μ =
 * 0.2, vx = 2 and ω = −jt·r/(r²/2) = −4 (it rolls to the right). At μ = 0.1 it slips: jt = 0.6, vx
 * = 2.4, ω = −2.4. Without gravity, so that the velocity at the impact is the one given.
 */
final class ObliqueDisc implements Scenes {

    private static final int PHASES = 5;

    @Override
    public void run(Trial trial) {
        for (int phase = 0; phase < PHASES; phase++) {
            double impact = (6 + (phase + 0.5) / PHASES) * Trial.DT;
            trial.variant("sticks, phase " + phase);
            bounce(trial, 0.2, impact, 2, -4);
            trial.variant("slips, phase " + phase);
            bounce(trial, 0.1, impact, 2.4, -2.4);
        }
    }

    private static void bounce(
            Trial trial, double friction, double impact, double vx, double spin) {
        WatchedPool pool = trial.space();
        pool.add(Earth.floor(friction, 0.5));
        RigidBody disc =
                pool.add(Solid.disc(0.5, friction, 0.5).at(0, 0.5 + 4 * impact).velocity(3, -4));
        pool.run(12 * Trial.DT);
        trial.measure("vx", Math.abs(disc.velocityX() - vx), "m/s", 1e-9, 1e-3);
        trial.measure("vy", Math.abs(disc.velocityY() - 2), "m/s", 1e-9, 1e-3);
        trial.measure("spin", Math.abs(disc.angularVelocity() - spin), "rad/s", 1e-9, 1e-3);
    }
}
