package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * Truth: momentum is kept and the relative velocity becomes −e of itself, so v1′ = ((m1 − e·m2)v1 +
 * (1 + e)m2·v2)/(m1 + m2) and likewise v2′, at t = gap/(v1 − v2). The place of the impact follows
 * from where both are afterwards.
 */
final class HeadOn implements Scenes {

    private static final double V1 = 3;
    private static final double V2 = -1;
    private static final double RADIUS = 0.5;
    private static final int PHASES = 5;
    private static final double[] RATIOS = {1, 10, 1e3, 1e6, 0.1, 1e-3, 1e-6};

    @Override
    public void run(Trial trial) {
        for (double ratio : RATIOS) {
            for (double e : new double[] {0, 0.5, 1}) {
                for (int phase = 0; phase < PHASES; phase++) {
                    trial.variant("m1:m2 " + ratio + ", e " + e + ", phase " + phase);
                    meet(trial, ratio, e, (10 + (phase + 0.5) / PHASES) * Trial.DT);
                }
            }
        }
    }

    private static void meet(Trial trial, double ratio, double e, double impact) {
        WatchedPool pool = trial.space();
        BodyDefinition disc = Solid.disc(RADIUS, 0, e);
        double m1 = Math.max(ratio, 1);
        double m2 = Math.max(1 / ratio, 1);
        double x1 = -RADIUS - V1 * impact;
        double x2 = RADIUS - V2 * impact;
        RigidBody one = pool.add(disc.at(x1, 0).velocity(V1, 0).mass(m1));
        RigidBody two = pool.add(disc.at(x2, 0).velocity(V2, 0).mass(m2));
        pool.run(20 * Trial.DT);
        double after1 = ((m1 - e * m2) * V1 + (1 + e) * m2 * V2) / (m1 + m2);
        double after2 = ((m2 - e * m1) * V2 + (1 + e) * m1 * V1) / (m1 + m2);
        double off1 = Math.abs(one.velocityX() - after1);
        double off2 = Math.abs(two.velocityX() - after2);
        trial.measure("velocities", Math.max(off1, off2) / (V1 - V2), "relative", 1e-12);
        double left = pool.time() - impact;
        double place1 = Math.abs(one.x() - (-RADIUS + after1 * left));
        double place2 = Math.abs(two.x() - (RADIUS + after2 * left));
        trial.measure("place", Math.max(place1, place2), "m", 1e-6, 1e-4);
    }
}
