package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Link;

import java.util.List;
import java.util.function.IntFunction;

/**
 * J15: a pile of ragdolls, a net of hinges and sprung doors. Joints hold to within 1 mm at any
 * time, and no energy is gained. Ragdolls have friction in their hinges and on each other, doors
 * are damped: they rest within 15 s and then sleep. A net has no damping.
 */
record JointCrowd(int few, int all, boolean rests, IntFunction<Scene> scene) implements Scenes {

    /** Speed below which a body is at rest, m/s. */
    private static final double REST = 1e-3;

    private static final double HORIZON = 15;
    private static final double JOINT_ERROR = 1e-3;

    @Override
    public void run(Trial trial) {
        int count = trial.sampling().count(few, all);
        trial.variant(count + " of them");
        Scene crowd = scene.apply(count);
        WatchedPool pool = trial.pool(crowd.effects().with(new Sleep()));
        List<RigidBody> bodies = crowd.bodies().stream().map(pool::add).toList();
        for (Link link : crowd.links()) {
            pool.join(link.between(bodies.get(link.a()), bodies.get(link.b())));
        }
        double fastest = 0;
        while (pool.time() < HORIZON) {
            pool.step();
            trial.measure("error of joints", pool.jointError(), "m", JOINT_ERROR);
            fastest = pool.fastest();
        }
        if (rests) {
            trial.measure("speed left", fastest, "m/s", REST);
            long awake =
                    bodies.stream()
                            .filter(body -> body.type() == BodyType.DYNAMIC && body.isAwake())
                            .count();
            trial.measure("bodies awake", awake, "bodies", 0);
        }
    }
}
