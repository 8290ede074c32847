package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * Truth: a box laid at rest on a belt of speed V slips under μmg for T = V/μg = 0.4077 s and moves
 * VT/2 = 0.4077 m meanwhile; from then on it is carried at V. So does a box with driven tracks on a
 * floor at rest. Friction also spins a disc: its rim gains 3μgt on the belt, so it rolls from V/3μg
 * on, at V/3. An impact that sticks gives a disc the speed V/3 at once.
 */
final class Conveyor implements Scenes {

    private static final double SPEED = 2;
    private static final double FRICTION = 0.5;
    private static final double SLIP_TIME = SPEED / (FRICTION * Trial.GRAVITY);
    private static final double SLIP_WAY = SPEED * SLIP_TIME / 2;

    @Override
    public void run(Trial trial) {
        trial.variant("box on a belt");
        takeUp(trial, Polygon.box(1, 0.5), -SPEED, 0, 1);
        trial.variant("box on tracks");
        takeUp(trial, Polygon.box(1, 0.5), 0, SPEED / 2, 1);
        trial.variant("disc on a belt");
        takeUp(trial, new Circle(0.25), -SPEED, 0, 1.0 / 3);
        trial.variant("disc dropped on a belt");
        strike(trial);
    }

    /**
     * Lays a body on a floor; surface speeds count counter-clockwise.
     *
     * @param share of the relative speed that the body ends with
     */
    private static void takeUp(
            Trial trial, Shape shape, double floorSpeed, double ownSpeed, double share) {
        WatchedPool pool = pool(trial);
        pool.add(Earth.floor(FRICTION, 0).material(matter(floorSpeed, 0)));
        RigidBody body =
                pool.add(BodyDefinition.dynamic(shape).at(0, 0.25).material(matter(ownSpeed, 0)));
        double end = -share * (floorSpeed + ownSpeed);
        double slipTime = SLIP_TIME * Math.abs(end) / SPEED;
        double slipWay = SLIP_WAY * end * Math.abs(end) / (SPEED * SPEED);
        double taken = 0;
        double error = 0;
        while (pool.time() < 2) {
            pool.step();
            double v = body.velocityX();
            double missing = Math.abs(end - v);
            if (missing > FRICTION * Trial.GRAVITY * Trial.DT) {
                taken = pool.time() + missing / (FRICTION * Trial.GRAVITY);
            } else if (pool.time() > slipTime + Trial.DT) {
                error = Math.max(error, missing);
            }
        }
        trial.relativeError("slip time", taken, slipTime, "of T", 1e-4, 1e-2);
        double way = body.x() - end * (pool.time() - slipTime);
        trial.relativeError("slip way", way, slipWay, "of VT/2", 1e-4, 1e-2);
        trial.measure("speed while carried", error, "m/s", 1e-9);
    }

    private static void strike(Trial trial) {
        WatchedPool pool = pool(trial);
        pool.add(Earth.floor(1, 0).material(matter(-SPEED, 0.5).friction(1)));
        RigidBody disc =
                pool.add(Solid.disc(0.25).at(0, 1.25).material(matter(0, 0.5).friction(1)));
        while (disc.velocityY() <= 0) {
            pool.step();
        }
        trial.measure("speed after", Math.abs(disc.velocityX() - SPEED / 3), "m/s", 1e-9, 1e-3);
        double rim = disc.angularVelocity() * 0.25;
        trial.measure("rim after", Math.abs(rim - 2 * SPEED / 3), "m/s", 1e-9, 1e-3);
    }

    private static WatchedPool pool(Trial trial) {
        Effects effects = Earth.effects().with(new SurfaceSpeed());
        return trial.pool(effects);
    }

    private static Material matter(double surfaceSpeed, double elasticity) {
        return Solid.matter(FRICTION, elasticity).surfaceSpeed(surfaceSpeed);
    }
}
