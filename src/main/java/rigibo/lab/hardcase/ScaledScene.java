package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Scenes 64 times larger or smaller, with gravity scaled likewise. Truth: all lengths and speeds
 * are scaled by a power of two, which changes no rounding, and tolerances are relative to bodies:
 * scaled back, every bit is equal.
 */
final class ScaledScene implements Scenes {

    private static final double SCALE = 64;
    private static final double HORIZON = 6;

    @Override
    public void run(Trial trial) {
        scenes(trial.sampling())
                .forEach(
                        (name, scene) -> {
                            compare(trial, name, scene, SCALE);
                            compare(trial, name, scene, 1 / SCALE);
                        });
    }

    private static Map<String, Scene> scenes(Sampling sampling) {
        long seed = sampling.random(15).nextLong();
        Map<String, Scene> scenes = new LinkedHashMap<>();
        int crowd = sampling.count(15, 80);
        scenes.put("rain", new Scene(Crowd.EFFECTS, Crowd.MIXED.rain(crowd, seed)));
        scenes.put("settling pyramid", Commotions.settling(sampling.count(6, 20), 0.01));
        scenes.put("towers", Commotions.towers(2, sampling.count(6, 20)));
        return scenes;
    }

    private static void compare(Trial trial, String name, Scene scene, double scale) {
        trial.variant(name + " × " + scale);
        StagedScene usual = new StagedScene(trial, scaled(scene, 1));
        StagedScene other = new StagedScene(trial, scaled(scene, scale));
        double same = 0;
        while (usual.pool().time() < HORIZON && isSame(usual, other, scale)) {
            same = usual.pool().time();
            usual.step();
            other.step();
        }
        boolean isSame = isSame(usual, other, scale);
        trial.measure("scenes that differ", isSame ? 0 : 1, "scenes", 0);
        trial.measure("time before the end", HORIZON - same, "s", Limits.NONE);
    }

    private static boolean isSame(StagedScene usual, StagedScene other, double scale) {
        List<RigidBody> bodies = usual.bodies();
        for (int i = 0; i < bodies.size(); i++) {
            RigidBody one = bodies.get(i);
            RigidBody two = other.bodies().get(i);
            boolean isThere = one.x() * scale == two.x() && one.y() * scale == two.y();
            if (!isThere || one.angle() != two.angle()) {
                return false;
            }
        }
        return true;
    }

    private static Scene scaled(Scene scene, double scale) {
        Gravity gravity = scene.effects().find(Gravity.class).orElseThrow();
        Effects effects =
                scene.effects().with(new Gravity(scale * gravity.x(), scale * gravity.y()));
        return new Scene(
                effects, scene.bodies().stream().map(body -> scaled(body, scale)).toList());
    }

    private static BodyDefinition scaled(BodyDefinition body, double scale) {
        BodyDefinition sized =
                switch (body.type()) {
                    case DYNAMIC -> BodyDefinition.dynamic(scaled(body.shape(), scale));
                    case KINEMATIC -> BodyDefinition.kinematic(scaled(body.shape(), scale));
                    case STATIC -> BodyDefinition.fixed(scaled(body.shape(), scale));
                };
        return sized.at(scale * body.x(), scale * body.y())
                .angle(body.angle())
                .velocity(scale * body.velocityX(), scale * body.velocityY())
                .spin(body.spin())
                .material(body.material());
    }

    private static Shape scaled(Shape shape, double scale) {
        if (shape instanceof Circle) {
            return new Circle(scale * ((Circle) shape).radius());
        }
        Polygon polygon = (Polygon) shape;
        double[] corners = new double[2 * polygon.corners()];
        for (int i = 0; i < polygon.corners(); i++) {
            corners[2 * i] = scale * polygon.cornerX(i);
            corners[2 * i + 1] = scale * polygon.cornerY(i);
        }
        return Polygon.of(corners);
    }
}
