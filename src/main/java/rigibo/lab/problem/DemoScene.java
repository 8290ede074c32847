package rigibo.lab.problem;

import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.engine.World;

import java.util.List;
import java.util.function.Consumer;

/**
 * A scene of one of the game's demos.
 *
 * @param name of the demo
 * @param looks number of samples before chaos sets in
 * @param effects that it calls for
 * @param thrust force on the first body, N to the right
 * @param bodies its bodies, the moving ones first
 */
record DemoScene(
        String name, int looks, Effects effects, double thrust, List<BodyDefinition> bodies) {

    /** The time between two looks, s: the longest step of the sweeps. */
    static final double LOOK = 1.0 / 30;

    /** The number of moving bodies. */
    int moving() {
        return (int) bodies.stream().filter(body -> body.type() == BodyType.DYNAMIC).count();
    }

    /** Adds its bodies to a world. */
    World build(World world) {
        bodies.forEach(world::add);
        return world;
    }

    /**
     * The places of all moving bodies at every look: x and y in turn, m.
     *
     * @param steps from one look to the next
     * @param step makes one
     */
    double[][] places(World world, int steps, Consumer<World> step) {
        int moving = moving();
        double[][] places = new double[looks][2 * moving];
        for (double[] seen : places) {
            for (int i = 0; i < steps; i++) {
                if (thrust != 0) {
                    world.push(0, thrust, 0);
                }
                step.accept(world);
            }
            for (int body = 0; body < moving; body++) {
                seen[2 * body] = world.x(body);
                seen[2 * body + 1] = world.y(body);
            }
        }
        return places;
    }
}
