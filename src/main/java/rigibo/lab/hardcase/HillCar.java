package rigibo.lab.hardcase;

import rigibo.backend.Joint;
import rigibo.backend.RigidBody;
import rigibo.backend.WheelJoint;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Solid;

import java.util.List;
import java.util.SplittableRandom;

/**
 * J13: a car on springs, with light wheels, on a slope β. Its rear wheel brakes it at rest. The
 * share of its weight W on that wheel follows from moments about the foot of the front wheel.
 * Driven with the torque that just holds it, F = W·sin β, the share stays, since the drive acts
 * along the slope. So it climbs if, and only if, tan β is below μ times that share of W·cos β.
 */
final class HillCar {

    private static final double RADIUS = 0.3;
    private static final double BASE = 1;
    private static final double BRAKE = 1e4;
    private static final double CHASSIS = 100;
    private static final double WHEEL = 1;

    /** Distance from the least friction at which the outcome is tested. */
    private static final Limits UNDECIDED = Limits.of(0.03, 0.01);

    private HillCar() {}

    static void run(Trial trial) {
        int count = trial.sampling().count(3, 25);
        int wrong = 0;
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double slope = 0.05 + 0.3 * random.nextDouble();
            double height = 0.3 + 0.5 * random.nextDouble();
            double hertz = 2 + 3 * random.nextDouble();
            trial.variant(slope + " rad, " + height + " m high, " + hertz + " Hz");
            double share = shareAtRest(trial, slope, height, hertz);
            double least = Math.tan(slope) / share;
            double margin = UNDECIDED.of(trial.preset());
            wrong += climbs(trial, slope, height, hertz, least * (1 + margin)) ? 0 : 1;
            wrong += climbs(trial, slope, height, hertz, least * (1 - margin)) ? 1 : 0;
        }
        trial.measure("wrong outcomes", wrong, "of " + 2 * count, Limits.same(0));
    }

    /** The car: the rear wheel, which drives, is the lower one. */
    private record Car(WatchedPool pool, RigidBody slope, List<RigidBody> parts, Joint rear) {

        /**
         * A car on a slope.
         *
         * @param bounce of half of the chassis on a spring, Hz: the joint's own are those of its
         *     wheel, which is light
         */
        static Car on(WatchedPool pool, double angle, double height, double bounce, double mu) {
            double hertz = bounce * Math.sqrt(CHASSIS / 2 * (1 / CHASSIS + 1 / WHEEL));
            Material ground = new Material(1, mu, 0);
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            RigidBody slope =
                    pool.add(Solid.fixed(100, 2).at(sin, -cos).angle(angle).material(ground));
            BodyDefinition wheel = Solid.disc(RADIUS).angle(angle);
            BodyDefinition body = Solid.box(2.2 * BASE, height).angle(angle);
            double up = RADIUS + height / 2 + 0.1;
            RigidBody chassis = pool.add(at(body, 0, up, cos, sin).mass(CHASSIS).group(1));
            RigidBody back =
                    pool.add(
                            at(wheel, -BASE, RADIUS, cos, sin)
                                    .mass(WHEEL)
                                    .material(ground)
                                    .group(1));
            RigidBody front =
                    pool.add(
                            at(wheel, BASE, RADIUS, cos, sin)
                                    .mass(WHEEL)
                                    .material(ground)
                                    .group(1));
            double along = angle + Math.PI / 2;
            Joint rear =
                    pool.join(
                            WheelJoint.at(chassis, back, back.x(), back.y(), along)
                                    .spring(hertz, 1)
                                    .motor(0, BRAKE));
            pool.join(WheelJoint.at(chassis, front, front.x(), front.y(), along).spring(hertz, 1));
            return new Car(pool, slope, List.of(chassis, back, front), rear);
        }

        private static BodyDefinition at(
                BodyDefinition body, double along, double up, double cos, double sin) {
            return body.at(along * cos - up * sin, along * sin + up * cos);
        }

        RigidBody back() {
            return parts.get(1);
        }

        RigidBody front() {
            return parts.get(2);
        }

        double weight() {
            return parts.stream().mapToDouble(RigidBody::mass).sum() * Trial.GRAVITY;
        }

        /** The load of the rear wheel, N, by moments about the foot of the front wheel. */
        double rearLoad(double angle) {
            double standX = front().x() + RADIUS * Math.sin(angle);
            double standing = Math.hypot(front().x() - back().x(), front().y() - back().y());
            double moments = 0;
            for (RigidBody part : parts) {
                moments += part.mass() * Trial.GRAVITY * (standX - part.x());
            }
            return moments / standing;
        }
    }

    private static double shareAtRest(Trial trial, double slope, double height, double hertz) {
        Car car = Car.on(trial.jointedEarth(), slope, height, hertz, 2);
        car.pool().run(6);
        double rear = car.rearLoad(slope);
        double all = car.weight() * Math.cos(slope);
        measure(trial, "load of the rear wheel", car, car.back(), rear);
        measure(trial, "load of the front wheel", car, car.front(), all - rear);
        car.pool().measureJoints();
        return rear / all;
    }

    private static void measure(Trial trial, String name, Car car, RigidBody wheel, double truth) {
        double load = car.pool().impulseBetween(wheel, car.slope()) / Trial.DT;
        trial.relativeError(name, load, truth, "of truth", JointLimits.FORCE);
    }

    private static boolean climbs(
            Trial trial, double slope, double height, double hertz, double mu) {
        Car car = Car.on(trial.jointedEarth().withEnergyOfItsOwn(), slope, height, hertz, mu);
        car.pool().run(6);
        double margin = UNDECIDED.of(trial.preset());
        double torque = car.weight() * Math.sin(slope) * RADIUS * (1 + margin / 3);
        car.rear().motor(-1000, torque);
        car.pool().changed();
        double start = car.parts().get(0).x();
        car.pool().run(3);
        return car.parts().get(0).x() > start;
    }
}
