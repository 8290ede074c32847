package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.StepReport;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * A kinematic wall pushes a box at 0.5 m/s along a floor against a fixed wall. Truth: the box has
 * no room, so either the overlap grows or the box escapes. It never passes through a wall unseen,
 * nothing explodes, and both contacts are reported as events.
 */
final class Crush implements Scenes {

    private static final double MOST_SPEED = 3;
    private static final double HORIZON = 3;

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.ground(0.5, 0).allowingOverlap();
        RigidBody fixed = pool.add(Solid.fixed(1, 6).at(2, 3.01));
        RigidBody press =
                pool.add(BodyDefinition.kinematic(Polygon.box(1, 6)).at(-1, 3.01).velocity(0.5, 0));
        RigidBody box = pool.add(Solid.box(1, 1).at(0.2, 0.5));
        boolean isPressed = false;
        boolean isToldOf = false;
        while (pool.time() < HORIZON) {
            StepReport report = pool.step();
            isToldOf |= report.crushed() > 0;
            double speed = Math.hypot(box.velocityX(), box.velocityY());
            trial.measure("fastest", speed, "m/s", MOST_SPEED);
            isPressed |=
                    pool.pool().touching(box, press)
                            && pool.pool().touching(box, fixed)
                            && pool.impulseBetween(box, press) > 0
                            && pool.impulseBetween(box, fixed) > 0;
        }
        trial.require("both contacts are told", isPressed);
        trial.require("it is told that the box is crushed", isToldOf);
        boolean isOutside = box.y() > 6.5;
        boolean isBetween = box.x() > press.x() && box.x() < fixed.x();
        trial.require("the box is between the walls or above them", isBetween || isOutside);
    }
}
