package rigibo.lab.hardcase;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Length;
import rigibo.backend.geometry.Logarithm;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * J15: trees of two to ten bodies, held together by joints of any kind, that fall between walls and
 * on each other. Bodies of one tree collide like those of different trees, except the two bodies of
 * a joint. Truth: no body enters another, joints hold, and no energy is gained.
 */
final class Contraptions {

    private static final double SECONDS = 6;

    /** Limits of overlap, in widths, as in a rain of boxes (M1). */
    private static final Limits OVERLAP = new Limits(0.5, 0.05, 0.02);

    /** Limits of the joints' error while trees strike each other, m. */
    private static final Limits ERROR = new Limits(0.05, 5e-3, 1e-3);

    /** Attempts to find a place for a body. */
    private static final int TRIES = 60;

    private final SplittableRandom random;
    private final WatchedPool pool;

    /** Places of all bodies. */
    private final List<Place> taken = new ArrayList<>();

    /**
     * A circle that holds a body.
     *
     * @param x of its centre, m
     * @param y likewise
     * @param radius m
     */
    private record Place(double x, double y, double radius) {

        private boolean isApart(Place other) {
            return Length.hypot(x - other.x, y - other.y) > radius + other.radius + 0.005;
        }
    }

    private Contraptions(SplittableRandom random, WatchedPool pool) {
        this.random = random;
        this.pool = pool;
    }

    static void run(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(3, 200)) {
            WatchedPool pool = trial.jointedEarth().withOverlapOfItsOwn();
            new Contraptions(random, pool).build();
            while (pool.time() < SECONDS) {
                pool.step();
                trial.measure("error of joints", pool.jointError(), "m", ERROR);
            }
            trial.measure("overlap", pool.deepestShare(), "widths", OVERLAP);
        }
    }

    private void build() {
        double friction = random.nextDouble();
        double elasticity = random.nextInt(3) == 0 ? between(0, 0.8) : 0;
        pool.add(BodyDefinition.fixed(Polygon.box(40, 2)).at(0, -1));
        pool.add(BodyDefinition.fixed(Polygon.box(2, 40)).at(-9, 19));
        pool.add(BodyDefinition.fixed(Polygon.box(2, 40)).at(9, 19));
        int trees = 1 + random.nextInt(3);
        for (int tree = 0; tree < trees; tree++) {
            grow(friction, elasticity);
        }
    }

    /** Adds a tree whose lightest bodies are up to a hundred times as light as its heaviest. */
    private void grow(double friction, double elasticity) {
        List<RigidBody> bodies = new ArrayList<>();
        List<Place> places = new ArrayList<>();
        double ratio = Logarithm.pow(10, between(0, 2));
        int count = 2 + random.nextInt(9);
        for (int i = 0; i < count; i++) {
            double size = between(0.15, 0.5);
            int parent = bodies.isEmpty() ? -1 : random.nextInt(bodies.size());
            Place place = find(parent < 0 ? null : places.get(parent), 1.6 * size);
            double density = Logarithm.pow(ratio, between(-0.5, 0.5));
            BodyDefinition body =
                    BodyDefinition.dynamic(shape(size))
                            .angle(between(0, 2 * Math.PI))
                            .velocity(between(-2, 2), between(-4, 2))
                            .spin(between(-3, 3))
                            .material(new Material(density, friction, elasticity));
            if (place != null) {
                RigidBody added = pool.add(body.at(place.x(), place.y()));
                if (parent >= 0) {
                    pool.join(joint(bodies.get(parent), places.get(parent), added, place));
                }
                bodies.add(added);
                places.add(place);
                taken.add(place);
            }
        }
    }

    /** A free place beside a parent's, or anywhere; null if none was found. */
    private Place find(Place parent, double radius) {
        for (int i = 0; i < TRIES; i++) {
            Place place;
            if (parent == null) {
                place = new Place(between(-7, 7), between(1.5, 9), radius);
            } else {
                double way = between(0, 2 * Math.PI);
                double far = parent.radius() + radius + between(0.01, 0.4);
                double x = parent.x() + far * Angle.cos(way);
                place = new Place(x, parent.y() + far * Angle.sin(way), radius);
            }
            boolean isWithin = place.y() > radius && Math.abs(place.x()) < 8 - radius;
            if (isWithin && taken.stream().allMatch(place::isApart)) {
                return place;
            }
        }
        return null;
    }

    /** A shape within 1.6 times its size. */
    private Shape shape(double size) {
        return switch (random.nextInt(4)) {
            case 0 -> new Circle(size);
            case 1 -> Polygon.box(2.4 * size, between(0.6, 1.6) * size);
            case 2 -> new Capsule(size, 0.6 * size);
            default -> Polygon.regular(3 + random.nextInt(4), size);
        };
    }

    private JointDefinition joint(RigidBody a, Place atA, RigidBody b, Place atB) {
        double x = (atA.x() + atB.x()) / 2;
        double y = (atA.y() + atB.y()) / 2;
        double apart = Length.hypot(atB.x() - atA.x(), atB.y() - atA.y());
        double way = Angle.atan2(atB.y() - atA.y(), atB.x() - atA.x());
        DistanceJoint rod = DistanceJoint.rod(a, atA.x(), atA.y(), b, atB.x(), atB.y());
        return switch (random.nextInt(9)) {
            case 0 -> RevoluteJoint.at(a, b, x, y);
            case 1 -> RevoluteJoint.at(a, b, x, y).limits(between(-1, -0.05), between(0.05, 1));
            case 2 -> RevoluteJoint.at(a, b, x, y).motor(0, between(0.1, 5));
            case 3 -> WeldJoint.at(a, b, x, y);
            case 4 -> WeldJoint.at(a, b, x, y).spring(between(1, 8), between(0.1, 1));
            case 5 -> PrismaticJoint.along(a, b, x, y, way).limits(-0.2, 0.2);
            case 6 -> rod;
            case 7 -> rod.spring(between(1, 6), between(0, 1));
            default -> {
                double length = apart * between(1.01, 1.5);
                yield DistanceJoint.rope(a, atA.x(), atA.y(), b, atB.x(), atB.y(), length);
            }
        };
    }

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }
}
