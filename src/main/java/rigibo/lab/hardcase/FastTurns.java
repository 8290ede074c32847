package rigibo.lab.hardcase;

import rigibo.backend.DistanceJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.SplittableRandom;

/**
 * J1/fast and J17/blows: what turns by up to 5 rad in a step about a joint, in space. Nothing takes
 * energy from it, and it turns at one rate, whatever straight ways the parts of a step have.
 */
final class FastTurns {

    private static final Limits ENERGY = Limits.of(1e-3, 1e-6);

    /**
     * Coarser at EXACT than a pendulum's period: nothing tells in the first step that a rope is
     * loaded, so that it is made in parts of the second order.
     */
    private static final Limits RATE = Limits.of(1e-3, 1e-4);

    private static final Limits SPEED = Limits.of(1e-3, 1e-9);

    private FastTurns() {}

    /** What turns about the origin. */
    private enum Piece {
        /** A bar, hinged at its end. */
        BAR,
        /** A disc on a rod. */
        ROD,
        /** A disc on a rope. */
        ROPE,
        /** Two discs with a rod between them. */
        PAIR,
        /** Three discs in a row, on rods. */
        DISCS,
        /** Three bars in a row, on hinges. */
        BARS
    }

    static void spin(Trial trial) {
        int count = trial.sampling().count(3, 30);
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double rate = i == 0 ? 300 : Math.pow(10, 1 + 1.5 * random.nextDouble());
            double length = 0.2 + random.nextDouble();
            for (Piece piece : Piece.values()) {
                trial.variant(piece + " of " + length + " m at " + rate + " rad/s");
                spin(trial, piece, length, rate);
            }
        }
    }

    private static void spin(Trial trial, Piece piece, double length, double rate) {
        WatchedPool pool = trial.jointedSpace().withEnergyOfItsOwn();
        RigidBody last = build(pool, piece, length, rate);
        double start = pool.energy();
        while (pool.time() < 0.5) {
            pool.step();
            double off = Math.abs(pool.energy() / start - 1);
            trial.measure("energy", off, "of the start", ENERGY);
            pool.measureJoints();
        }
        double turned = rate * pool.time();
        double angle = Math.atan2(last.x(), -last.y());
        double late = Math.IEEEremainder(angle - turned, 2 * Math.PI);
        trial.measure("rate", Math.abs(late) / turned, "of truth", RATE);
    }

    /** Builds a piece that turns at a rate in rad/s; returns its outermost body, at −y. */
    private static RigidBody build(WatchedPool pool, Piece piece, double length, double rate) {
        BodyDefinition disc = Solid.disc(length / 5, 0, 0).mass(0.2).group(1);
        BodyDefinition bar = Solid.box(length / 5, length, 0, 0).mass(0.2).group(1);
        int count = piece == Piece.DISCS || piece == Piece.BARS ? 3 : 1;
        boolean isOfBars = piece == Piece.BAR || piece == Piece.BARS;
        RigidBody before =
                piece == Piece.PAIR ? turning(pool, disc, length, rate) : pool.hook(0, 0);
        double from = piece == Piece.PAIR ? length : 0;
        for (int i = 0; i < count; i++) {
            double to = -(i + 1) * length;
            double centre = isOfBars ? to + length / 2 : to;
            RigidBody body = turning(pool, isOfBars ? bar : disc, centre, rate);
            if (isOfBars) {
                pool.join(RevoluteJoint.at(before, body, 0, from));
            } else if (piece == Piece.ROPE) {
                pool.join(DistanceJoint.rope(before, 0, from, body, 0, to, from - to));
            } else {
                pool.join(DistanceJoint.rod(before, 0, from, body, 0, to));
            }
            before = body;
            from = to;
        }
        return before;
    }

    private static RigidBody turning(WatchedPool pool, BodyDefinition body, double y, double rate) {
        return pool.add(body.at(0, y).velocity(-rate * y, 0).spin(rate));
    }

    static void strike(Trial trial) {
        int count = trial.sampling().count(6, 60);
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double mass = Math.pow(10, 2 * random.nextDouble() - 1);
            double speed = 10 + 80 * random.nextDouble();
            double elasticity = 0.8 + 0.2 * random.nextDouble();
            double away = 1 + random.nextDouble();
            String of = mass + " kg at " + speed + " m/s, e " + elasticity;
            for (Piece piece : new Piece[] {Piece.BAR, Piece.ROD, Piece.PAIR}) {
                trial.variant(piece + ", " + of + ", after " + away + " steps");
                strike(trial, piece, mass, speed, elasticity, away);
            }
        }
    }

    /**
     * A ball strikes a piece at rest across its joint, at a depth d. With k what a unit impulse
     * does there, 1/M for a disc and d²/I for a bar, J = (1 + e)·v/(1/m + k), and the impact takes
     * (1 − e²)·v²/2(1/m + k) of the energy. Such elastic contacts part so fast that a bar which
     * turns does not come back to the ball at once; a second impact ends the case.
     */
    private static void strike(
            Trial trial, Piece piece, double mass, double speed, double elasticity, double away) {
        WatchedPool pool = trial.jointedSpace().withEnergyOfItsOwn();
        double length = 1;
        RigidBody struck = build(pool, piece, length, 0);
        double depth = piece == Piece.BAR ? 0.6 : 1;
        double thickness = piece == Piece.BAR ? length / 10 : length / 5;
        double x = -0.1 - thickness - away * speed * Trial.DT;
        RigidBody ball =
                pool.add(
                        Solid.disc(0.1, 0, elasticity).at(x, -depth).mass(mass).velocity(speed, 0));
        double inertia = struck.inertia() + struck.mass() / 4;
        double response = piece == Piece.BAR ? depth * depth / inertia : 1 / struck.mass();
        double reduced = 1 / (1 / mass + response);
        double start = mass * speed * speed / 2;
        double kept = 1 - (1 - elasticity * elasticity) * reduced / mass;
        int impacts = 0;
        while (pool.time() < 6.5 * Trial.DT && impacts < 2) {
            pool.step();
            impacts += pool.pool().report().impacts();
            if (impacts == 1) {
                double off = Math.abs(pool.energy() / start - kept);
                trial.measure("energy after the impact", off, "of the start", ENERGY);
                double truth = speed - (1 + elasticity) * speed * reduced / mass;
                off = Math.abs(ball.velocityX() - truth) / speed;
                trial.measure("speed of what struck", off, "of v", SPEED);
                pool.measureJoints();
            }
        }
        trial.require("the ball strikes once at least", impacts > 0);
    }
}
