package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * Two smooth squares at 45° meet vertex to vertex, e = 1. Truth: energy is kept whatever normal the
 * vertices choose, and the mirrored scene is mirrored where the offset decides the direction.
 */
final class CornerOnCorner implements Scenes {

    private static final double SPEED = 4;

    /**
     * The gap at which EXACT may take an impact, m. At an offset of this size the direction from
     * vertex to vertex is arbitrary, and so is the deflection.
     */
    private static final double IMPACT_GAP = 1e-8;

    private static final double HALF_DIAGONAL = Math.sqrt(0.5);

    @Override
    public void run(Trial trial) {
        for (double offset : new double[] {0, 1e-9, 1e-4}) {
            RigidBody left = meet(trial, -offset);
            RigidBody right = meet(trial, offset);
            double off =
                    Math.hypot(
                                    left.velocityX() - right.velocityX(),
                                    left.velocityY() + right.velocityY())
                            + Math.abs(left.angularVelocity() + right.angularVelocity());
            if (offset > IMPACT_GAP) {
                trial.measure("mirrored", off / SPEED, "of v", 1e-6, 1e-3);
            } else {
                trial.report("mirrored, too near to tell", off / SPEED, "of v");
            }
        }
    }

    private static RigidBody meet(Trial trial, double offset) {
        trial.variant("offset " + offset);
        WatchedPool pool = trial.space();
        BodyDefinition square = Solid.box(1, 1, 0, 1).angle(Math.PI / 4);
        double x = HALF_DIAGONAL + SPEED * 6.4 * Trial.DT;
        RigidBody a = pool.add(square.at(-x, offset / 2).velocity(SPEED, 0));
        RigidBody b = pool.add(square.at(x, -offset / 2).velocity(-SPEED, 0));
        double energy = a.kineticEnergy() + b.kineticEnergy();
        pool.run(1);
        double change = (a.kineticEnergy() + b.kineticEnergy()) / energy - 1;
        trial.measure("energy changed", Math.abs(change), "of E", 1e-6);
        return a;
    }
}
