package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * Five equal elastic discs in a row between two walls, touching or 1 mm apart; the first k come in
 * at v. Truth: the last k leave at v and the others stay: the limit of impacts one after the other,
 * as a row with gaps has them. Energy is kept for a hundred crossings.
 */
final class Cradle implements Scenes {

    private static final int COUNT = 5;
    private static final double SPEED = 2;
    private static final double APPROACH = 0.5;
    private static final double FREE_WAY = 2;
    private static final int CROSSINGS = 100;

    @Override
    public void run(Trial trial) {
        for (double gap : new double[] {0, 1e-3}) {
            for (int launched = 1; launched < COUNT; launched++) {
                trial.variant("gap " + gap + ", launched " + launched);
                strike(trial, gap, launched);
            }
        }
    }

    private static void strike(Trial trial, double gap, int launched) {
        WatchedPool pool = trial.space();
        BodyDefinition wall = Solid.fixed(1, 4, 0, 1);
        double end = (COUNT - 1) * (1 + gap) + 0.5;
        pool.add(wall.at(-APPROACH - FREE_WAY - 1, 0));
        pool.add(wall.at(end + FREE_WAY + 0.5, 0));
        BodyDefinition disc = Solid.disc(0.5, 0, 1);
        List<RigidBody> row = new ArrayList<>();
        for (int i = 0; i < COUNT; i++) {
            double x = i * (1 + gap) - (i < launched ? APPROACH : 0);
            row.add(pool.add(disc.at(x, 0).velocity(i < launched ? SPEED : 0, 0)));
        }
        double energy = pool.pool().kineticEnergy();
        // After the impacts, and before the first disc that leaves reaches the wall.
        pool.run(APPROACH / SPEED + 0.5);
        for (int i = 0; i < COUNT; i++) {
            double truth = i >= COUNT - launched ? SPEED : 0;
            double off = Math.abs(row.get(i).velocityX() - truth) / SPEED;
            trial.measure("velocity", off, "of v", 1e-6, 1e-2);
        }
        pool.run(CROSSINGS * (FREE_WAY + APPROACH) / SPEED);
        trial.relativeError("energy changed", pool.pool().kineticEnergy(), energy, "of E", 1e-6);
    }
}
