package rigibo.lab.bench.probe;

import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Outline;
import rigibo.lab.truth.OutlineSweep;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * The deepest overlap of two bodies of a scene, computed from their positions, whatever the engine
 * reports.
 */
public final class DeepestOverlap {

    private DeepestOverlap() {}

    /** The deepest overlap in m; 0 if no bodies overlap. */
    static double in(Scene scene, World world) {
        return deepest(scene, world, shape -> 1);
    }

    /** The deepest overlap in widths of the smaller body; 0 if none overlap. */
    public static double inWidths(Scene scene, World world) {
        return deepest(scene, world, Shape::smallestWidth);
    }

    private static double deepest(Scene scene, World world, ToDoubleFunction<Shape> unit) {
        Map<Outline, Integer> numberOf = new IdentityHashMap<>();
        OutlineSweep sweep =
                new OutlineSweep(unit, (a, b) -> scene.meet(numberOf.get(a), numberOf.get(b)));
        List<BodyDefinition> bodies = scene.bodies();
        for (int i = 0; i < bodies.size(); i++) {
            if (i != scene.loss().body()) {
                Outline outline = new Outline(bodies.get(i).shape());
                numberOf.put(outline, i);
                outline.place(world.x(i), world.y(i), world.angle(i));
                sweep.add(outline, bodies.get(i).type() == BodyType.DYNAMIC);
            }
        }
        return sweep.deepest();
    }
}
