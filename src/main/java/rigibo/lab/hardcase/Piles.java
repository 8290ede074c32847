package rigibo.lab.hardcase;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;

/** Piles that are put elsewhere, or into motion as a whole, where they must fare the same. */
final class Piles {

    /** s after which a small heap lies. */
    private static final double SETTLED = 12;

    private Piles() {}

    /** One that stands, one that falls together, one that has fallen. */
    static Map<String, Scene> some(Sampling sampling) {
        long seed = sampling.random(0).nextLong();
        Map<String, Scene> piles = new LinkedHashMap<>();
        piles.put("pyramid", Commotions.settling(sampling.count(10, 30), 0));
        piles.put("settling pyramid", Commotions.settling(sampling.count(7, 15), 0.01));
        List<BodyDefinition> heap = Crowd.BOXES.rain(sampling.count(25, 100), seed);
        piles.put("heap", new Scene(Crowd.EFFECTS, settled(heap)));
        return piles;
    }

    /** A crowd where it lies in the end, at rest. */
    static List<BodyDefinition> settled(List<BodyDefinition> bodies) {
        Pool pool = new Pool(Crowd.EFFECTS, Preset.GAME.accuracy());
        List<RigidBody> heap = bodies.stream().map(pool::add).toList();
        while (pool.time() < SETTLED) {
            pool.step(Trial.DT);
        }
        List<BodyDefinition> lying = new ArrayList<>();
        for (int i = 0; i < heap.size(); i++) {
            RigidBody body = heap.get(i);
            lying.add(bodies.get(i).at(body.x(), body.y()).angle(body.angle()));
        }
        return lying;
    }

    /** The pile so many m to the right. */
    static Scene shifted(Scene scene, double x) {
        return each(scene, body -> body.at(body.x() + x, body.y()));
    }

    /** The pile, and all it rests on, moving to the right at so many m/s. */
    static Scene moving(Scene scene, double speed) {
        return each(scene, body -> carrier(body).velocity(speed, 0));
    }

    private static BodyDefinition carrier(BodyDefinition body) {
        return body.type() == BodyType.DYNAMIC
                ? body
                : BodyDefinition.kinematic(body.shape())
                        .at(body.x(), body.y())
                        .angle(body.angle())
                        .material(body.material());
    }

    private static Scene each(Scene scene, UnaryOperator<BodyDefinition> change) {
        return new Scene(scene.effects(), scene.bodies().stream().map(change).toList());
    }
}
