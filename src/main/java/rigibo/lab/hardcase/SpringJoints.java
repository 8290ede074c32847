package rigibo.lab.hardcase;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Joint;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;
import rigibo.lab.truth.Solid;

import java.util.SplittableRandom;

/**
 * J8. On a spring q″ + 2ζω·q′ + ω²·q = 0: q = q₀·e^(−ζωt)·(cos ω′t + (ζω/ω′)·sin ω′t), ω′ = ω·√(1 −
 * ζ²). An error of a share ε in period or decay becomes an error of ε·ωt of the envelope after t. A
 * spring too stiff for the step is tested for what holds for any spring: it is stretched by mg/k at
 * rest, never leaves its envelope, and gains no energy.
 */
final class SpringJoints {

    private static final Limits SHARE = Limits.of(1e-2, 1e-4);

    /** A quarter of the rate of steps, Hz: above it a swing has less than four steps. */
    private static final double FASTEST = 1 / (4 * Trial.DT);

    /** Envelopes below are not looked at, as a share of the start. */
    private static final double FADED = 1e-3;

    /** Amplitude of a swing that counts as rest: a tenth of the strictest limit. */
    private static final double AT_REST = 1e-5;

    private enum Kind {
        PRISMATIC,
        DISTANCE,
        WELD
    }

    private SpringJoints() {}

    static void run(Trial trial) {
        int count = trial.sampling().count(4, 30);
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double hertz = i == 0 ? FASTEST : 0.5 + (FASTEST - 0.5) * random.nextDouble();
            double ratio = i % 2 == 0 ? 0 : 0.5 * random.nextDouble();
            double stiff = FASTEST * Math.pow(150, random.nextDouble());
            double damping = 0.05 + 0.95 * random.nextDouble();
            double mass = Math.pow(10, 2 - 4 * random.nextDouble());
            for (Kind kind : Kind.values()) {
                String words = kind + ", " + mass + " kg, ";
                trial.variant(words + hertz + " Hz, ζ " + ratio);
                swing(trial, kind, mass, hertz, ratio);
                trial.variant(words + stiff + " Hz, ζ " + damping);
                recoil(trial, kind, mass, stiff, damping);
                trial.variant(words + stiff + " Hz, ζ " + damping + ", loaded");
                bear(trial, kind, mass, stiff, damping);
            }
        }
    }

    /** A body on a spring whose other end is at the origin. */
    private record Sprung(WatchedPool pool, RigidBody body, Joint joint, Kind kind) {

        static Sprung of(WatchedPool pool, Kind kind, double mass, JointSpring spring) {
            RigidBody hook = pool.hook(0, 0);
            RigidBody body = pool.add(Solid.disc(0.2).at(1, 0).mass(mass));
            JointSettings soft = JointSettings.NONE.spring(spring);
            JointFrame centre = JointFrame.CENTRE;
            Joint joint =
                    switch (kind) {
                        case PRISMATIC ->
                                pool.join(PrismaticJoint.along(hook, body, 1, 0, 0).with(soft));
                        case DISTANCE ->
                                pool.join(new DistanceJoint(hook, body, centre, centre, 1, soft));
                        case WELD -> pool.join(WeldJoint.at(hook, body, 1, 0).with(soft));
                    };
            return new Sprung(pool, body, joint, kind);
        }

        /** How far the spring is from its rest, m or rad. */
        double away() {
            return kind == Kind.WELD ? joint.angle() : body.x() - 1;
        }

        void strain(double by) {
            if (kind == Kind.WELD) {
                body.moveTo(1, 0, by);
            } else {
                body.moveTo(1 + by, 0, 0);
            }
            pool.changed();
        }
    }

    private static void swing(Trial trial, Kind kind, double mass, double hertz, double ratio) {
        WatchedPool pool = trial.jointedSpace().withEnergyOfItsOwn();
        Sprung sprung = Sprung.of(pool, kind, mass, new JointSpring(hertz, ratio));
        double start = 0.2;
        sprung.strain(start);
        double omega = 2 * Math.PI * hertz;
        double damped = omega * Math.sqrt(1 - ratio * ratio);
        while (pool.time() < 20 / hertz && Math.exp(-ratio * omega * pool.time()) > FADED) {
            pool.step();
            double t = pool.time();
            double wave = Math.cos(damped * t) + ratio * omega / damped * Math.sin(damped * t);
            double envelope = Math.exp(-ratio * omega * t);
            double off = Math.abs(sprung.away() / start - envelope * wave) / envelope;
            trial.measure("period and decay", off / Math.max(1, omega * t), "", SHARE);
        }
    }

    private static void recoil(Trial trial, Kind kind, double mass, double hertz, double ratio) {
        WatchedPool pool = trial.jointedSpace();
        Sprung sprung = Sprung.of(pool, kind, mass, new JointSpring(hertz, ratio));
        double start = 0.2;
        sprung.strain(start);
        double decay = ratio * 2 * Math.PI * hertz;
        while (pool.time() < 1) {
            pool.step();
            // The terms with √(1 − ζ²) in the denominator must start with 1 at t = 0.
            double envelope = Math.exp(-decay * pool.time()) / Math.sqrt(1 - ratio * ratio);
            double beyond = Math.abs(sprung.away()) / start - Math.min(1, envelope);
            trial.measure("outside of the envelope", Math.max(0, beyond), "of the start", SHARE);
        }
    }

    private static void bear(Trial trial, Kind kind, double mass, double hertz, double ratio) {
        WatchedPool pool = trial.jointedEarth();
        RigidBody hook = pool.hook(0, 0);
        RigidBody body = pool.add(Solid.disc(0.2).at(0, -1).mass(mass));
        JointSettings soft = JointSettings.NONE.spring(new JointSpring(hertz, ratio));
        double down = -Math.PI / 2;
        if (kind == Kind.WELD) {
            bend(trial, pool, hook, body, soft);
            return;
        }
        Joint joint =
                kind == Kind.PRISMATIC
                        ? pool.join(PrismaticJoint.along(hook, body, 0, -1, down).with(soft))
                        : pool.join(
                                new DistanceJoint(
                                        hook, body, JointFrame.CENTRE, JointFrame.CENTRE, 1, soft));
        pool.run(10);
        double truth = mass * Trial.GRAVITY / joint.stiffness();
        trial.relativeError("deflection", -1 - body.y(), truth, "of mg/k", SHARE);
    }

    /**
     * A body of whose centre a weld holds a point 1 m beside: m·g·cos θ = −k·θ. It swings about the
     * hook with I + m·1², far more than the spring was damped for, and fades by c/2(I + m·1²).
     */
    private static void bend(
            Trial trial, WatchedPool pool, RigidBody hook, RigidBody body, JointSettings soft) {
        body.moveTo(1, 0, 0);
        Joint joint = pool.join(WeldJoint.at(hook, body, 0, 0).with(soft));
        double decay = joint.damping() / (2 * (body.inertia() + body.mass()));
        pool.run(Math.max(10, Math.log(1 / AT_REST) / decay));
        double angle = joint.angle();
        double truth = body.mass() * Trial.GRAVITY * Math.cos(angle) / joint.stiffness();
        trial.relativeError("deflection", -angle, truth, "of mg/k", SHARE);
    }
}
