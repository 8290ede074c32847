package rigibo.lab.hardcase;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Logarithm;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * J4, J5 and J12: links in a row. A link that carries W at its centre, between a pull of H to
 * either side and V₋ and V₊ = V₋ − W upwards and downwards, is in balance at tan θ = (V₋ + V₊)/2H,
 * by moments about its centre. Links laid at these angles are at rest, and the ends are held by
 * √(H² + V²). A hanging chain pulls by its weight, and a cantilever loads its wall by weight times
 * lever.
 */
final class HangingChains {

    /** Limits of swings, as of every pendulum (J1). */
    private static final Limits SWING = Limits.of(1e-3, 1e-6);

    private static final Limits STRETCH = Limits.of(1e-3, 1e-6);
    private static final Limits REACTION = Limits.of(1e-2, 1e-6);
    private static final Limits MOMENT = Limits.of(2e-2, 1e-4);

    private HangingChains() {}

    static void catenaries(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(3, 20)) {
            int links = 50;
            double length = 0.1 + 0.4 * random.nextDouble();
            double mass = mass(length, length / 4);
            double pull = links * mass * Trial.GRAVITY * (0.3 + 2 * random.nextDouble());
            trial.variant(links + " links of " + length + " m, pulled by " + pull + " N");
            WatchedPool pool = trial.jointedEarth();
            Laid chain = new Laid(pool, length, length / 4, pull);
            for (int k = 0; k < links; k++) {
                chain.add(links * mass * Trial.GRAVITY / 2, mass * Trial.GRAVITY, k);
            }
            chain.end();
            chain.stays(trial, 10, JointLimits.FORCE);
        }
    }

    /** Mass of a link at a density of 1, kg. */
    private static double mass(double length, double height) {
        return length * height;
    }

    /** Links in balance, laid from the origin to the right, fixed at both ends. */
    private static final class Laid {

        private final WatchedPool pool;
        private final double length;
        private final double height;
        private final double pull;
        private final List<RigidBody> links = new ArrayList<>();
        private double carried;
        private double first;
        private double x;
        private double y;
        private Joint left;
        private Joint right;

        Laid(WatchedPool pool, double length, double height, double pull) {
            this.pool = pool;
            this.length = length;
            this.height = height;
            this.pull = pull;
        }

        /**
         * Lays the next link.
         *
         * @param up force on the left end of the first link, N
         * @param weight that this one carries, N
         */
        void add(double up, double weight, int k) {
            first = up;
            double before = up - carried;
            carried += weight;
            double angle = -Angle.atan2(before + up - carried, 2 * pull);
            double dx = length * Angle.cos(angle);
            double dy = length * Angle.sin(angle);
            RigidBody link =
                    pool.add(
                            Solid.box(length, height, 1, 0)
                                    .at(x + dx / 2, y + dy / 2)
                                    .angle(angle));
            RigidBody held = k == 0 ? pool.hook(x, y) : links.get(k - 1);
            Joint joint = pool.join(RevoluteJoint.at(held, link, x, y));
            left = k == 0 ? joint : left;
            links.add(link);
            x += dx;
            y += dy;
        }

        void end() {
            RigidBody last = links.get(links.size() - 1);
            right = pool.join(RevoluteJoint.at(last, pool.hook(x, y), x, y));
        }

        /** Puts a box on a link so that its weight goes through the link's centre. */
        void load(int k, double side, double mass) {
            RigidBody link = links.get(k);
            double up = (height + side) / 2;
            double along = Angle.sin(link.angle()) / Angle.cos(link.angle()) * up;
            pool.add(
                    Solid.box(side, side, 1, 0)
                            .at(link.worldX(along, up), link.worldY(along, up))
                            .angle(link.angle())
                            .mass(mass));
        }

        void stays(Trial trial, double seconds, Limits forces) {
            double[] places = links.stream().mapToDouble(RigidBody::y).toArray();
            while (pool.time() < seconds) {
                pool.step();
                pool.measureJoints();
            }
            for (int k = 0; k < places.length; k++) {
                double off = Math.abs(links.get(k).y() - places[k]) / length;
                trial.measure("moved", off, "of a link", JointLimits.PLACE);
            }
            double leftTruth = Math.hypot(pull, first);
            double rightTruth = Math.hypot(pull, carried - first);
            trial.relativeError(
                    "tension, left", left.reactionForce(), leftTruth, "of truth", forces);
            trial.relativeError(
                    "tension, right", right.reactionForce(), rightTruth, "of truth", forces);
        }
    }

    static void heavyBobs(Trial trial) {
        hangAll(trial, List.of(Line.LINKS));
    }

    static void heavyBobsOnLines(Trial trial) {
        hangAll(trial, List.of(Line.RODS, Line.ROPES));
    }

    /**
     * Weights that no number of substeps follows, on short and on long lines. What the vibration is
     * damped by takes energy from the swing as well; it may add none.
     */
    static void heaviestBobs(Trial trial) {
        int count = trial.sampling().count(3, 15);
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double length = 0.1 + 0.3 * random.nextDouble();
            double ratio = i == 0 ? 1e6 : Logarithm.pow(10, 4 + 2 * random.nextDouble());
            double angle = 0.3 + random.nextDouble();
            int links = 2 + random.nextInt(20);
            for (Line line : Line.values()) {
                String of = links + " " + line + " of " + length + " m, 1:" + ratio;
                trial.variant(of + ", from " + angle + " rad");
                swing(trial, line, links, length, ratio, angle);
            }
        }
    }

    private static void swing(
            Trial trial, Line line, int links, double length, double ratio, double angle) {
        WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
        RigidBody bob = hang(pool, line, links, length, ratio, angle);
        double swing = bob.mass() * Trial.GRAVITY * links * length * (1 - Math.cos(angle));
        double start = pool.energy();
        while (pool.time() < 3) {
            pool.step();
            double gained = (pool.energy() - start) / swing;
            trial.measure("energy gained", Math.max(0, gained), "of the swing", SWING);
            pool.measureJoints();
        }
    }

    /** What carries a bob. */
    private enum Line {
        /** Thin boxes, each hinged to the next. */
        LINKS,
        /** Discs, with rods from centre to centre. */
        RODS,
        /** Discs, with ropes from centre to centre. */
        ROPES,
        /** Boxes, with rods from edge to edge. */
        EDGES
    }

    private static void hangAll(Trial trial, List<Line> lines) {
        int count = trial.sampling().count(3, 15);
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double length = 0.1 + 0.3 * random.nextDouble();
            double ratio = i == 0 ? 1e4 : Logarithm.pow(10, 4 * random.nextDouble());
            double angle = 0.3 + random.nextDouble();
            for (Line line : lines) {
                String of = line + " of " + length + " m, 1:" + ratio;
                trial.variant(of + ", at rest");
                hang(trial, line, length, ratio, 0);
                trial.variant(of + ", from " + angle + " rad");
                hang(trial, line, length, ratio, angle);
            }
        }
    }

    /**
     * Hangs pieces in a straight line, with a bob at the end, {@code links} lengths from the hook
     * and some times as heavy as a piece; returns the bob.
     */
    private static RigidBody hang(
            WatchedPool pool, Line line, int links, double length, double ratio, double angle) {
        RigidBody before = pool.hook(0, 0);
        double dx = length * Angle.sin(angle);
        double dy = -length * Angle.cos(angle);
        int pieces = pieces(line, links);
        for (int k = 0; k < pieces; k++) {
            RigidBody piece = pool.add(piece(line, length, k, dx, dy).angle(angle).group(1));
            pool.join(joint(line, before, piece, k, dx, dy));
            before = piece;
        }
        RigidBody bob =
                pool.add(
                        Solid.disc(length / 2)
                                .at(links * dx, links * dy)
                                .mass(ratio * before.mass())
                                .group(1));
        pool.join(joint(line, before, bob, pieces, dx, dy));
        return bob;
    }

    private static int pieces(Line line, int links) {
        return line == Line.LINKS ? links : links - 1;
    }

    /** Thirty pieces with a bob, at rest or let swing. */
    private static void hang(Trial trial, Line line, double length, double ratio, double angle) {
        int links = 30;
        WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
        RigidBody bob = hang(pool, line, links, length, ratio, angle);
        int pieces = pieces(line, links);
        double mass = bob.mass() / ratio;
        double height = (ratio + links / 2.0) * links * length * (1 - Math.cos(angle));
        double swing = mass * Trial.GRAVITY * height;
        double start = pool.energy();
        while (pool.time() < 3) {
            pool.step();
            if (angle > 0) {
                double off = Math.abs(pool.energy() - start) / swing;
                trial.measure("energy of the swing", off, "of its own", SWING);
            }
            double stretch = Math.hypot(bob.x(), bob.y()) / (links * length) - 1;
            trial.measure("stretch", Math.max(0, stretch), "of length", STRETCH);
            pool.measureJoints();
        }
        if (angle == 0) {
            double truth = (ratio + pieces) * mass * Trial.GRAVITY;
            trial.relativeError(
                    "reaction",
                    pool.pool().joints().get(0).reactionForce(),
                    truth,
                    "of truth",
                    REACTION);
        }
    }

    private static BodyDefinition piece(Line line, double length, int k, double dx, double dy) {
        return switch (line) {
            case LINKS -> Solid.box(length / 4, length).at((k + 0.5) * dx, (k + 0.5) * dy);
            case RODS, ROPES -> Solid.disc(length / 8).at((k + 1) * dx, (k + 1) * dy);
            case EDGES -> Solid.box(length / 8, length / 2).at((k + 1) * dx, (k + 1) * dy);
        };
    }

    /** The joint above the piece of a number. */
    private static JointDefinition joint(
            Line line, RigidBody above, RigidBody piece, int k, double dx, double dy) {
        double x = k * dx;
        double y = k * dy;
        return switch (line) {
            case LINKS -> RevoluteJoint.at(above, piece, x, y);
            case RODS -> DistanceJoint.rod(above, x, y, piece, x + dx, y + dy);
            case ROPES ->
                    DistanceJoint.rope(above, x, y, piece, x + dx, y + dy, Math.hypot(dx, dy));
            case EDGES ->
                    DistanceJoint.rod(
                            above, x + dx / 4, y + dy / 4, piece, x + 3 * dx / 4, y + 3 * dy / 4);
        };
    }

    static void bridges(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(2, 15)) {
            double length = 0.4 + 0.6 * random.nextDouble();
            int at = 10 + random.nextInt(20);
            double heavier = 1 + 10 * random.nextDouble();
            trial.variant("planks of " + length + " m, " + heavier + " planks on the " + at + "th");
            stand(trial, length, at, heavier);
            trial.variant("planks of " + length + " m, a disc rolls over them");
            roll(trial, length, 0.1 + 0.4 * random.nextDouble());
            trial.variant("20 pieces of " + length + " m");
            reachOut(trial, length, length * (0.1 + random.nextDouble()));
        }
    }

    private static void stand(Trial trial, double length, int at, double heavier) {
        int planks = 40;
        double mass = mass(length, length / 5);
        double weight = mass * Trial.GRAVITY;
        double all = (planks + heavier) * weight;
        WatchedPool pool = trial.jointedEarth();
        Laid bridge = new Laid(pool, length, length / 5, 1.5 * all);
        for (int k = 0; k < planks; k++) {
            bridge.add(all / 2, k == at ? (1 + heavier) * weight : weight, k);
        }
        bridge.end();
        bridge.load(at, length / 2, heavier * mass);
        bridge.stays(trial, 5, MOMENT);
    }

    /** A disc rolls over planks without slack; the guard checks the energy. */
    private static void roll(Trial trial, double length, double radius) {
        int planks = 40;
        WatchedPool pool = trial.jointedEarth();
        double weight = mass(length, length / 5) * Trial.GRAVITY;
        Laid bridge = new Laid(pool, length, length / 5, planks * weight * 2);
        for (int k = 0; k < planks; k++) {
            bridge.add(planks * weight / 2, weight, k);
        }
        bridge.end();
        RigidBody first = bridge.links.get(2);
        double up = length / 10 + radius;
        pool.add(Solid.disc(radius, 1, 0).at(first.worldX(0, up), first.worldY(0, up)));
        while (pool.time() < 8) {
            pool.step();
            pool.measureJoints();
        }
    }

    private static void reachOut(Trial trial, double length, double height) {
        int pieces = 20;
        WatchedPool pool = trial.jointedEarth();
        RigidBody before = pool.hook(0, 0);
        for (int k = 0; k < pieces; k++) {
            RigidBody piece = pool.add(Solid.box(length, height).at((k + 0.5) * length, 0));
            pool.join(WeldJoint.at(before, piece, k * length, 0));
            before = piece;
        }
        pool.run(3);
        double weight = pieces * before.mass() * Trial.GRAVITY;
        Joint wall = pool.pool().joints().get(0);
        trial.relativeError(
                "moment at the wall",
                wall.reactionTorque(),
                weight * pieces * length / 2,
                "of truth",
                MOMENT);
        pool.measureJoints();
    }
}
