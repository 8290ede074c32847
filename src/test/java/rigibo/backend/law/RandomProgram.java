package rigibo.backend.law;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.ArrayList;
import java.util.List;

/**
 * Edits of a pool, drawn from a seed for each step by itself, so that a restored pool gets the same
 * ones as the original.
 */
public final class RandomProgram {

    /** The floor and the walls of a tray come first and stay. */
    private static final int TRAY = 3;

    /** A body is thrown at the others so often, in steps; what sleeps is woken within the step. */
    private static final int STEPS_PER_IMPACT = 37;

    private static final int STEPS_PER_EDIT = 23;

    private RandomProgram() {}

    /** Bodies in a tray, a driven one among them, under effects of all kinds. */
    static RandomScene scene(long seed, Accuracy accuracy) {
        RandomScene heap = Surroundings.settling(seed, accuracy, 10);
        Draw draw = new Draw(seed + 1);
        List<BodyDefinition> bodies = new ArrayList<>();
        for (BodyDefinition body : heap.bodies()) {
            bodies.add(body.material(body.material().drag(0.1).surfaceSpeed(draw.whole(0, 1))));
        }
        bodies.add(
                BodyDefinition.kinematic(Polygon.box(0.8, 0.3))
                        .at(draw.between(-2, 2), draw.between(4, 6))
                        .velocity(0, draw.between(-0.5, 0.5))
                        .spin(draw.between(-1, 1)));
        return heap.effects(RandomEffects.of(draw)).bodies(bodies);
    }

    /** A pool of that kind before its first step. */
    public static Pool pool(long seed) {
        List<Accuracy> presets =
                List.of(Accuracy.GAME, Accuracy.DRAFT, Accuracy.FINE, Accuracy.EXACT);
        return scene(seed, presets.get((int) (seed % presets.size()))).pool();
    }

    /** Does what is due at a step of a number, and makes it. */
    public static void step(Pool pool, long seed, int number) {
        long drawn = 1000 * seed + number;
        if (number % STEPS_PER_IMPACT == STEPS_PER_IMPACT - 1) {
            strike(pool, new Draw(drawn));
        }
        if (number % STEPS_PER_EDIT == STEPS_PER_EDIT - 1) {
            new RandomEdits(pool, TRAY, drawn).rough();
        }
        pool.step(RandomScene.DT);
    }

    private static void strike(Pool pool, Draw draw) {
        List<RigidBody> loose =
                pool.bodies().stream().filter(b -> b.type() == BodyType.DYNAMIC).toList();
        if (loose.isEmpty()) {
            return;
        }
        RigidBody struck = draw.oneOf(loose);
        struck.velocity(draw.between(-4, 4), draw.between(-4, 4));
        if (pool.effects().declares(Thrust.class)) {
            struck.applyForce(draw.between(-5, 5), 3, struck.x() + 0.1, struck.y());
        }
    }
}
