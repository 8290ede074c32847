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

/** Crowds of other shapes than boxes and discs, as large and as wild as a {@link Crowd}. */
final class ShapeCrowds {

    /** Half the width and half the height of a cave, m. */
    private static final double CAVE_X = 40;

    private static final double CAVE_Y = 22;

    /** How far its wall goes in and out, as a share of that, and how often all round. */
    private static final double ROUGHNESS = 0.02;

    private static final int BUMPS = 40;

    private ShapeCrowds() {}

    /** So many compounds of two to five parts in turn, at any angle, that rain into a trough. */
    static Scene compounds(int count, long seed) {
        List<Shape> kinds = List.of(angle(), dumbbell(), fork(), cross());
        return rain(count, seed, i -> kinds.get(i % kinds.size()));
    }

    /** So many capsules of 0.5 to 0.9 m by 0.2 to 0.4 m that rain into a trough. */
    static Scene capsules(int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed + 1);
        return rain(
                count,
                seed,
                i ->
                        new Capsule(
                                0.15 + 0.1 * random.nextDouble(), 0.1 + 0.1 * random.nextDouble()));
    }

    /** So many boxes and discs that fall onto the rough ground of a cave of so many edges. */
    static Scene cave(int count, int edges, long seed) {
        double[] xy = new double[2 * edges];
        for (int i = 0; i < edges; i++) {
            // Clockwise, for the matter is outside.
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

    /** A crowd of boxes in a trough, each of which is given another shape in its place. */
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
