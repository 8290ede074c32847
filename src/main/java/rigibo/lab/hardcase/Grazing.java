package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * A smooth elastic disc of ½ m passes the corner of a post at 100 m/s, its path 0.1 mm too high or
 * too low, or flies through a gap 2 mm wider than itself. Truth: the high one and the one in the
 * gap keep their velocity to the last bit. The low one touches where the normal has ny = 1 − 2e-4
 * and leaves with v − 2(v·n)n. A path that meets the corner δ too early has ny smaller by 2δ: GAME,
 * where δ may be 0.1 mm, determines the angle to about half of itself, which is 0.02 of v.
 */
final class Grazing implements Scenes {

    private static final double RADIUS = 0.5;
    private static final double SPEED = 100;
    private static final double CLEARANCE = 1e-4;

    @Override
    public void run(Trial trial) {
        for (double phase : new double[] {0.1, 0.5, 0.9}) {
            trial.variant("above, phase " + phase);
            RigidBody above = passCorner(trial, CLEARANCE, phase);
            misses(trial, above);
            trial.variant("below, phase " + phase);
            grazes(trial, passCorner(trial, -CLEARANCE, phase));
            trial.variant("gap, phase " + phase);
            misses(trial, passGap(trial, phase));
        }
    }

    private static void misses(Trial trial, RigidBody disc) {
        double change =
                Math.abs(disc.velocityX() - SPEED)
                        + Math.abs(disc.velocityY())
                        + Math.abs(disc.angularVelocity());
        trial.measure("velocity changed by a miss", change, "m/s", 0);
    }

    private static void grazes(Trial trial, RigidBody disc) {
        double ny = (RADIUS - CLEARANCE) / RADIUS;
        double nx = -Math.sqrt(1 - ny * ny);
        double vx = SPEED - 2 * SPEED * nx * nx;
        double vy = -2 * SPEED * nx * ny;
        double off = Math.hypot(disc.velocityX() - vx, disc.velocityY() - vy);
        trial.measure("velocity after a graze", off / SPEED, "of v", 1e-4, 2e-2);
        double speed = Math.hypot(disc.velocityX(), disc.velocityY());
        trial.relativeError("speed changed by a graze", speed, SPEED, "of v", 1e-9);
    }

    private static RigidBody passCorner(Trial trial, double clearance, double phase) {
        WatchedPool pool = trial.space();
        pool.add(post().at(0.5, -2));
        return fly(pool, RADIUS + clearance, phase);
    }

    private static RigidBody passGap(Trial trial, double phase) {
        WatchedPool pool = trial.space();
        double half = RADIUS + 1e-3;
        pool.add(post().at(0.5, -2 - half));
        pool.add(post().at(0.5, 2 + half));
        return fly(pool, 0, phase);
    }

    private static BodyDefinition post() {
        return Solid.fixed(1, 4, 0, 1);
    }

    private static RigidBody fly(WatchedPool pool, double y, double phase) {
        double start = -SPEED * (2 + phase) * Trial.DT;
        RigidBody disc = pool.add(Solid.disc(RADIUS, 0, 1).at(start, y).velocity(SPEED, 0));
        pool.run(6 * Trial.DT);
        return disc;
    }
}
