package rigibo.lab.bench.large;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * A world of very many bodies: three fifths of them lie in heaps of sixty, a fifth rolls along
 * floors, and a fifth is in flight and meets nothing. Fixed bodies are not counted.
 */
final class LargeWorld {

    /** Boxes of a heap: a pyramid of ten storeys, and five beside it. */
    static final int HEAP = 60;

    private static final int STOREYS = 10;
    private static final int BESIDE = 5;

    /** The distance between heaps, m. */
    private static final double PITCH = 30;

    private static final int HEAPS_IN_A_ROW = 50;

    /** The number of discs on a floor, and the distance between them, m. */
    private static final int ROLLING = 100;

    private static final double BETWEEN = 3;
    private static final double SPEED = 2;
    private static final double RADIUS = 0.25;

    /** The x to the left of all heaps at which the floors of the rolling discs end, m. */
    private static final double LEFT = -1000;

    /**
     * The bodies in flight: their number in a row, their distance in m, their speed in m/s, their
     * height in m.
     */
    private static final int ABREAST = 400;

    private static final double SPACING = 2.5;
    private static final double THROWN = 20;
    private static final double HEIGHT = 5000;

    private static final Polygon BOX = Polygon.box(1, 1);

    final Pool pool = new Pool(Effects.usual(), Accuracy.GAME);

    /** The movable bodies, in the order they were added. */
    final List<RigidBody> bodies = new ArrayList<>();

    /** A world with a number of movable bodies that is a multiple of 500. */
    static LargeWorld of(int count) {
        LargeWorld world = new LargeWorld();
        world.heaps(count * 3 / 5 / HEAP);
        world.rolling(count / 5);
        world.flying(count / 5);
        return world;
    }

    /** A world with heaps only, which fall asleep. */
    static LargeWorld ofHeaps(int count) {
        LargeWorld world = new LargeWorld();
        world.heaps(count / HEAP);
        return world;
    }

    private void heaps(int count) {
        for (int heap = 0; heap < count; heap++) {
            double x = PITCH * (heap % HEAPS_IN_A_ROW);
            double y = PITCH * (heap / HEAPS_IN_A_ROW);
            pool.add(BodyDefinition.fixed(Polygon.box(PITCH - 2, 1)).at(x, y - 0.5));
            for (int storey = 0; storey < STOREYS; storey++) {
                for (int i = 0; i < STOREYS - storey; i++) {
                    add(BOX, x + 1.05 * (i - (STOREYS - 1 - storey) / 2.0), y + storey + 0.5);
                }
            }
            for (int i = 0; i < BESIDE; i++) {
                add(BOX, x + 7 + 1.05 * i, y + 0.5);
            }
        }
    }

    private void add(Polygon shape, double x, double y) {
        bodies.add(pool.add(BodyDefinition.dynamic(shape).at(x, y)));
    }

    private void rolling(int count) {
        double length = BETWEEN * (ROLLING + 20);
        for (int i = 0; i < count; i++) {
            int floor = i / ROLLING;
            double y = 5.0 * floor;
            if (i % ROLLING == 0) {
                double middle = LEFT - length / 2;
                pool.add(BodyDefinition.fixed(Polygon.box(length, 1)).at(middle, y - 0.5));
            }
            BodyDefinition disc = BodyDefinition.dynamic(new Circle(RADIUS));
            double x = LEFT - BETWEEN * (ROLLING + 15 - i % ROLLING);
            bodies.add(pool.add(disc.at(x, y + RADIUS).velocity(SPEED, 0).spin(-SPEED / RADIUS)));
        }
    }

    private void flying(int count) {
        for (int i = 0; i < count; i++) {
            double x = SPACING * (i % ABREAST);
            double y = HEIGHT + SPACING * (i / ABREAST);
            bodies.add(pool.add(BodyDefinition.dynamic(BOX).at(x, y).velocity(x / 50, THROWN)));
        }
    }
}
