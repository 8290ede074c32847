package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.lab.truth.Solid;

/**
 * Bodies dropped with a horizontal velocity. Truth: friction turns two thirds of a disc's velocity
 * into rolling (m·v = m·v′ + I·v′/r²), which goes on; a flat box stops within v²/2μg of where it
 * landed. A box whose side exceeds μ times its height cannot tip, since the friction μN has the
 * lever h/2 and the weight w/2. Of boxes of equal area, those with longer sides turn less.
 */
final class RoundRolls implements Scenes {

    private static final double DROP = 0.2;
    private static final double SPEED = 4;
    private static final double FRICTION = 0.9;
    private static final double HORIZON = 8;

    @Override
    public void run(Trial trial) {
        trial.variant("disc");
        RigidBody disc = fall(trial, new Circle(0.5), 0.5);
        double rolling = 2 * SPEED / 3;
        trial.relativeError("rolling speed", disc.velocityX(), rolling, "of 2v/3", 1e-2);
        double slip = Math.abs(disc.velocityX() + disc.angularVelocity() / 2);
        trial.measure("slip of the rolling disc", slip, "m/s", 1e-6);
        double before = Double.POSITIVE_INFINITY;
        boolean anyTumbled = false;
        for (double ratio : new double[] {0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 4}) {
            trial.variant("box with side to height " + ratio);
            double width = Math.sqrt(ratio);
            RigidBody box = fall(trial, Polygon.box(width, 1 / width), 0.5 / width);
            double quarters = Math.rint(Math.abs(box.angle()) / (Math.PI / 2));
            trial.require("the longer the side, the less it turns", quarters <= before);
            trial.require("cannot tip beyond mu", ratio < FRICTION || quarters == 0);
            anyTumbled |= quarters > 0;
            before = quarters;
            double speed = Math.hypot(box.velocityX(), box.velocityY());
            trial.measure("speed of a box in the end", speed, "m/s", 1e-3);
        }
        trial.require("a tall one tumbles", anyTumbled);
    }

    private static RigidBody fall(Trial trial, Shape shape, double above) {
        WatchedPool pool = trial.ground(FRICTION, 0);
        RigidBody body =
                pool.add(Solid.of(shape, FRICTION, 0).at(-20, above + DROP).velocity(SPEED, 0));
        pool.run(HORIZON);
        return body;
    }
}
