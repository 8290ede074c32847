package rigibo.lab.hardcase;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Thrust;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointSettings;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.SplittableRandom;

/**
 * J9, J10 and J14. A motor of torque τ accelerates I to ω = τ·t/I up to its speed, one of force F
 * lifts m to v = (F/m − g)·t; its work is the energy gained. A body that strikes a limit at ω
 * leaves it at −e·ω, with e² of its energy. A joint breaks in the step in which its impulse exceeds
 * F·dt, that of an impact included.
 */
final class DrivenJoints {

    private static final Limits EXACTLY = Limits.of(1e-3, 1e-9);
    private static final Limits AT_LIMIT = Limits.of(1e-4, 1e-9);
    private static final Limits BREAK = Limits.of(2e-2, 1e-4);

    private DrivenJoints() {}

    static void motors(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(4, 30)) {
            double size = 0.2 + random.nextDouble();
            // Whole steps, so that the motor exerts its maximum or minimum throughout each.
            double time = (20 + random.nextInt(60)) * Trial.DT;
            double most = Math.pow(10, 3 * random.nextDouble() - 1);
            trial.variant("turning " + size + " m with " + most + " N·m for " + time + " s");
            turn(trial, size, most, time);
            trial.variant("lifting " + size + " m at " + most + " g for " + time + " s");
            lift(trial, size, 1.1 + most, time);
        }
    }

    private static void turn(Trial trial, double size, double most, double time) {
        WatchedPool pool = trial.jointedSpace().withEnergyOfItsOwn();
        RigidBody hook = pool.hook(0, 0);
        RigidBody wheel = pool.add(Solid.box(size, 2 * size));
        double speed = most * time / wheel.inertia();
        Joint hinge = pool.join(RevoluteJoint.at(hook, wheel, 0, 0).motor(speed, most));
        double work = 0;
        while (pool.time() < 2 * time) {
            double before = wheel.angularVelocity();
            pool.step();
            double truth = speed * Math.min(1, pool.time() / time);
            double off = Math.abs(wheel.angularVelocity() - truth) / speed;
            trial.measure("speed", off, "of the motor's", EXACTLY);
            double mean = (before + wheel.angularVelocity()) / 2;
            work += hinge.reactionTorque() * mean * Trial.DT;
        }
        double energy = wheel.inertia() * speed * speed / 2;
        trial.relativeError("work", work, energy, "of energy", EXACTLY);
    }

    private static void lift(Trial trial, double size, double weights, double time) {
        WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
        RigidBody hook = pool.hook(0, 0);
        RigidBody cabin = pool.add(Solid.box(size, size));
        double speed = (weights - 1) * Trial.GRAVITY * time;
        double most = weights * cabin.mass() * Trial.GRAVITY;
        JointDefinition slide = PrismaticJoint.along(hook, cabin, 0, 0, Math.PI / 2);
        Joint joint = pool.join(slide.motor(speed, most));
        double work = 0;
        double start = pool.energy();
        while (pool.time() < 2 * time) {
            double before = cabin.y();
            pool.step();
            double truth = speed * Math.min(1, pool.time() / time);
            double off = Math.abs(cabin.velocityY() - truth) / speed;
            trial.measure("speed", off, "of the motor's", EXACTLY);
            work += joint.reactionForceY() * (cabin.y() - before);
        }
        trial.relativeError("work", work, pool.energy() - start, "of energy", EXACTLY);
    }

    static void limits(Trial trial) {
        int count = trial.sampling().count(4, 30);
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double elasticity = i % 2 == 0 ? 0 : random.nextDouble();
            double speed = Math.pow(10, 2 * random.nextDouble() - 1);
            double room = 0.2 + random.nextDouble();
            for (boolean isHinge : new boolean[] {false, true}) {
                String words = (isHinge ? "hinge" : "slide") + " at " + speed + "/s, e ";
                trial.variant(words + elasticity + ", room " + room);
                strike(trial, isHinge, speed, room, elasticity);
            }
            trial.variant("a bar falls on its limit at " + -room + " rad");
            fall(trial, room);
        }
    }

    private static void strike(
            Trial trial, boolean isHinge, double speed, double room, double elasticity) {
        WatchedPool pool = trial.jointedSpace();
        RigidBody hook = pool.hook(0, 0);
        BodyDefinition bar = Solid.box(1, 0.2).at(0.5, 0);
        RigidBody body =
                pool.add(isHinge ? bar.spin(speed).velocity(0, speed / 2) : bar.velocity(speed, 0));
        JointDefinition joint =
                isHinge
                        ? RevoluteJoint.at(hook, body, 0, 0)
                        : PrismaticJoint.along(hook, body, 0.5, 0, 0);
        JointSettings stop = JointSettings.NONE.limits(new JointLimits(-9, room, elasticity));
        Joint limited = pool.join(joint.with(stop));
        double start = pool.energy();
        double beyond = 0;
        while (pool.time() < 1.5 * room / speed + Trial.DT) {
            pool.step();
            double at = isHinge ? limited.angle() : limited.translation();
            beyond = Math.max(beyond, at - room);
        }
        trial.measure("beyond the limit", beyond, "rad or m", AT_LIMIT);
        double kept = pool.energy() / start;
        double off = Math.abs(kept - elasticity * elasticity);
        trial.measure("energy kept", off, "of e²", AT_LIMIT);
        double way = isHinge ? limited.angle() : limited.translation();
        double truth = room - elasticity * Math.max(0, speed * pool.time() - room);
        trial.measure("place after it", Math.abs(way - truth), "rad or m", AT_LIMIT);
    }

    /** Falls against a limit; until then it swings, and its energy may err by what J1 allows. */
    private static void fall(Trial trial, double room) {
        WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
        RigidBody hook = pool.hook(0, 0);
        RigidBody bar = pool.add(Solid.box(1, 0.1).at(0.5, 0));
        Joint hinge = pool.join(RevoluteJoint.at(hook, bar, 0, 0).limits(-room, 9));
        while (pool.time() < 4) {
            pool.step();
            double beyond = Math.max(0, -room - hinge.angle());
            trial.measure("beyond the limit", beyond, "rad or m", AT_LIMIT);
        }
        double off = Math.abs(hinge.angle() + room);
        trial.measure("place at rest", off, "rad", AT_LIMIT);
    }

    static void breaks(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(3, 20)) {
            double force = Math.pow(10, 4 * random.nextDouble() - 1);
            double mass = force / Trial.GRAVITY * 0.5 * random.nextDouble();
            for (int kind = 0; kind < 3; kind++) {
                trial.variant("kind " + kind + ", " + mass + " kg, " + force + " N");
                pull(trial, kind, mass, force);
                strike(trial, kind, mass, force);
            }
        }
    }

    /** Hangs a bob on a rod, a hinge or a weld. */
    private static Joint hang(WatchedPool pool, int kind, double mass, double force) {
        RigidBody hook = pool.hook(0, 0);
        RigidBody bob = pool.add(Solid.disc(0.1).at(0, -1).mass(mass));
        JointDefinition joint =
                switch (kind) {
                    case 0 -> DistanceJoint.rod(hook, 0, 0, bob, 0, -1);
                    case 1 -> RevoluteJoint.at(hook, bob, 0, 0);
                    default -> WeldJoint.at(hook, bob, 0, 0);
                };
        return pool.join(joint.breaking(force, Double.POSITIVE_INFINITY));
    }

    private static void pull(Trial trial, int kind, double mass, double force) {
        WatchedPool pool =
                trial.pool(
                        Earth.space()
                                .with(new Joints())
                                .with(new Thrust())
                                .with(new Gravity(0, -Trial.GRAVITY)));
        Joint joint = hang(pool, kind, mass, force);
        RigidBody bob = joint.b();
        double share = 0.97;
        while (joint.isAlive() && share < 1.03) {
            share += 1e-5;
            double thrust = share * force - mass * Trial.GRAVITY;
            bob.applyForce(0, -thrust, bob.x(), bob.y());
            pool.step();
        }
        trial.measure("load that breaks it", Math.abs(share - 1), "of F", BREAK);
    }

    /** Strikes a bob that hangs still: the impact and the weight act on the joint at once. */
    private static void strike(Trial trial, int kind, double mass, double force) {
        double margin = BREAK.of(trial.preset());
        for (int side = -1; side <= 1; side += 2) {
            WatchedPool pool = trial.jointedEarth();
            Joint joint = hang(pool, kind, mass, force);
            pool.step();
            double impulse = ((1 + side * margin) * force - mass * Trial.GRAVITY) * Trial.DT;
            joint.b().applyImpulse(0, -impulse, joint.b().x(), joint.b().y());
            pool.changed();
            pool.step();
            boolean holds = joint.isAlive();
            trial.require(
                    side < 0 ? "holds against a smaller impact" : "breaks by a greater impact",
                    holds == (side < 0));
        }
    }
}
