package rigibo.lab.bench.scene;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntFunction;

/** Crowds like a {@link Crowd}, but of other shapes than boxes and discs. */
final class ShapeCrowds {

    /** Half the width and half the height of the cave, m. */
    private static final double CAVE_X = 40;

    private static final double CAVE_Y = 22;

    /**
     * The waves of the cave's wall: their amplitude, as a share of those, and their number around
     * the cave.
     */
    private static final double ROUGHNESS = 0.02;

    private static final int BUMPS = 40;

    private ShapeCrowds() {}

    /** Compounds of two to five parts that rain into a trough at any angle. */
    static Scene compounds(int count, long seed) {
        List<Shape> kinds = List.of(angle(), dumbbell(), fork(), cross());
        return rain(count, seed, i -> kinds.get(i % kinds.size()));
    }

    /** Capsules of 0.5 to 0.9 m by 0.2 to 0.4 m that rain into a trough. */
    static Scene capsules(int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed + 1);
        return rain(
                count,
                seed,
                i ->
                        new Capsule(
                                0.15 + 0.1 * random.nextDouble(), 0.1 + 0.1 * random.nextDouble()));
    }

    /** Boxes and discs that fall onto the rough ground of a cave. */
    static Scene cave(int count, int edges, long seed) {
        double[] xy = new double[2 * edges];
        for (int i = 0; i < edges; i++) {
            // The corners run clockwise, since the matter is outside.
            double around = -2 * Math.PI * i / edges;
            double reach = 1 + ROUGHNESS * Math.sin(BUMPS * around);
            xy[2 * i] = reach * CAVE_X * Math.cos(around);
            xy[2 * i + 1] = reach * CAVE_Y * Math.sin(around);
        }
        List<BodyDefinition> bodies = new ArrayList<>();
        bodies.add(BodyDefinition.fixed(Chain.loop(xy)).material(Crowd.STONE));
        bodies.addAll(Crowd.MIXED.rows(count, 25, -12, seed));
        return new Scene(Crowd.EFFECTS, bodies);
    }

    /** A crowd in a trough whose boxes are replaced by another shape. */
    private static Scene rain(int count, long seed, IntFunction<Shape> shapes) {
        List<BodyDefinition> bodies = new ArrayList<>(Crowd.BOXES.rain(count, seed));
        int walls = bodies.size() - count;
        for (int i = 0; i < count; i++) {
            BodyDefinition box = bodies.get(walls + i);
            bodies.set(walls + i, box.shape(shapes.apply(i)));
        }
        return new Scene(Crowd.EFFECTS, bodies);
    }

    private static Compound angle() {
        return Compound.of(
                Part.of(Polygon.box(0.8, 0.2)), Part.of(Polygon.box(0.2, 0.5)).at(-0.3, 0.35));
    }

    private static Compound dumbbell() {
        return Compound.of(
                Part.of(Polygon.box(0.6, 0.12)),
                Part.of(new Circle(0.2)).at(-0.35, 0),
                Part.of(new Circle(0.2)).at(0.35, 0));
    }

    private static Compound fork() {
        return Compound.of(
                Part.of(Polygon.box(0.8, 0.2)),
                Part.of(Polygon.box(0.2, 0.4)).at(-0.3, 0.3),
                Part.of(Polygon.box(0.2, 0.4)).at(0.3, 0.3),
                Part.of(Polygon.box(0.2, 0.3)).at(0, -0.25));
    }

    private static Compound cross() {
        return Compound.of(
                Part.of(Polygon.box(0.3, 0.3)),
                Part.of(Polygon.box(0.3, 0.2)).at(-0.3, 0),
                Part.of(Polygon.box(0.3, 0.2)).at(0.3, 0),
                Part.of(Polygon.box(0.2, 0.3)).at(0, -0.3),
                Part.of(Polygon.box(0.2, 0.3)).at(0, 0.3));
    }
}
