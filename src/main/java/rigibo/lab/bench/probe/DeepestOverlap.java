package rigibo.lab.bench.probe;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Outline;

import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/** The deepest overlap of two bodies of a scene, from where they are, whatever the engine says. */
public final class DeepestOverlap {

    private final List<BodyDefinition> bodies;
    private final ToDoubleFunction<Shape> unit;
    private final Outline[] outlines;
    private final Aabb[] bounds;

    /** The scene as its world stands, to be measured by the lesser of the units of each two. */
    private DeepestOverlap(Scene scene, World world, ToDoubleFunction<Shape> unit) {
        this.unit = unit;
        bodies = scene.bodies();
        outlines = new Outline[bodies.size()];
        bounds = new Aabb[outlines.length];
        for (int i = 0; i < outlines.length; i++) {
            if (i == scene.loss().body()) {
                continue;
            }
            place(i, world.x(i), world.y(i), world.angle(i));
        }
    }

    private void place(int i, double x, double y, double angle) {
        outlines[i] = new Outline(bodies.get(i).shape());
        outlines[i].place(x, y, angle);
        bounds[i] = new Aabb();
        outlines[i].shape().bounds(x, y, Math.cos(angle), Math.sin(angle), bounds[i]);
    }

    /** m; 0 where none overlap. */
    static double in(Scene scene, World world) {
        return new DeepestOverlap(scene, world, shape -> 1).sweep();
    }

    /** In widths, the smallest extents, of the smaller of the two bodies; 0 where none overlap. */
    public static double inWidths(Scene scene, World world) {
        return new DeepestOverlap(scene, world, Shape::smallestWidth).sweep();
    }

    /** From left to right: only what begins before a body ends can overlap it. */
    private double sweep() {
        int[] byLeft =
                IntStream.range(0, outlines.length)
                        .filter(i -> outlines[i] != null)
                        .boxed()
                        .sorted(Comparator.comparingDouble(i -> bounds[i].minX))
                        .mapToInt(Integer::intValue)
                        .toArray();
        double deepest = 0;
        for (int i = 0; i < byLeft.length; i++) {
            int a = byLeft[i];
            for (int j = i + 1; j < byLeft.length; j++) {
                int b = byLeft[j];
                if (bounds[b].minX > bounds[a].maxX) {
                    break;
                }
                deepest = Math.max(deepest, depth(a, b));
            }
        }
        return deepest;
    }

    /** Of two, 0 or less where they are apart or neither can give way. */
    private double depth(int a, int b) {
        boolean isBeside =
                bounds[a].minY > bounds[b].maxY
                        || bounds[b].minY > bounds[a].maxY
                        || !(isDynamic(a) || isDynamic(b));
        if (isBeside) {
            return 0;
        }
        return -outlines[a].separation(outlines[b]) / Math.min(unit(a), unit(b));
    }

    private double unit(int body) {
        return unit.applyAsDouble(outlines[body].shape());
    }

    private boolean isDynamic(int body) {
        return bodies.get(body).type() == BodyType.DYNAMIC;
    }
}
