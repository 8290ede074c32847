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

/** Piles that are moved elsewhere or carried along as a whole, where they must behave equally. */
final class Piles {

    /** The time after which a small heap is at rest, s. */
    private static final double SETTLED = 12;

    private Piles() {}

    /** A pyramid that stands, one that settles, and a heap that has fallen. */
    static Map<String, Scene> some(Sampling sampling) {
        long seed = sampling.random(0).nextLong();
        Map<String, Scene> piles = new LinkedHashMap<>();
        piles.put("pyramid", Commotions.settling(sampling.count(10, 30), 0));
        piles.put("settling pyramid", Commotions.settling(sampling.count(7, 15), 0.01));
        List<BodyDefinition> heap = Crowd.BOXES.rain(sampling.count(25, 100), seed);
        piles.put("heap", new Scene(Crowd.EFFECTS, settled(heap)));
        return piles;
    }

    /** A crowd at the places where it comes to rest. */
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

    /** A pile moved to the right by a distance in m. */
    static Scene shifted(Scene scene, double x) {
        return each(scene, body -> body.at(body.x() + x, body.y()));
    }

    /** A pile and all that carries it, moving to the right at a speed in m/s. */
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
