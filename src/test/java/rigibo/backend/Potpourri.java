package rigibo.backend;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.Random;

/**
 * A scene with some of everything: piles, sleepers, bouncing balls, a paddle and a turning bar that
 * are driven, thrust, drag, bodies that come and go. What is done to it in a step depends on the
 * pool and the step's number alone, so that a restored pool can be treated alike.
 */
final class Potpourri {

    static final Effects EFFECTS =
            Effects.of(
                    new Gravity(0.1, -9.81),
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new RollingResistance(),
                    new Drag(),
                    new Thrust(),
                    new ContinuousImpacts(),
                    new Sleep(0.4, 2e-4));

    private static final int PADDLE = 3;
    private static final int FIRST_LOOSE = 6;

    private Potpourri() {}

    static Pool build(Accuracy accuracy) {
        Pool pool = new Pool(EFFECTS, accuracy);
        Scenes.addTray(pool);
        pool.add(BodyDefinition.kinematic(Polygon.box(1.5, 0.4)).at(-6, 0.3).name("paddle"));
        pool.add(BodyDefinition.kinematic(Polygon.box(3, 0.3)).at(6, 3).spin(1.3).name("bar"));
        pool.add(BodyDefinition.fixed(Polygon.box(8, 0.4)).at(0, 14).name("shelf"));
        Scenes.addMixture(pool, 14);
        addStack(pool);
        addBalls(pool);
        for (int i = 0; i < 4; i++) {
            pool.add(BodyDefinition.dynamic(Polygon.box(0.6, 0.6)).at(2 * i - 3, 14.5));
        }
        pool.add(
                BodyDefinition.dynamic(Polygon.of(3, 3, 4.1, 3.2, 4.3, 4, 3.1, 3.7))
                        .at(7.5, 0.6)
                        .awake(false)
                        .gravityScale(0.5)
                        .mass(0.7)
                        .name("asleep \uD83D"));
        return pool;
    }

    private static void addStack(Pool pool) {
        Material rubber = new Material(1, 0.9, 0.1).rollingResistance(0.01).drag(0.05);
        for (int i = 0; i < 5; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.6, 0.6))
                            .at(-8, 0.3 + 0.6 * i)
                            .material(rubber)
                            .name("box " + i));
        }
    }

    private static void addBalls(Pool pool) {
        for (int i = 0; i < 6; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.25))
                            .at(2 * i - 5, 8 + 0.3 * i)
                            .velocity(3 - i, 0)
                            .group(i % 2)
                            .inertia(0.02)
                            .material(new Material(1, 0.1, 1)));
        }
    }

    /** Lets the steps pass whose numbers are from the first to before the last. */
    static void run(Pool pool, int first, int last) {
        for (int i = first; i < last; i++) {
            step(pool, i);
        }
    }

    /** Does what is due at a step, and makes it. */
    static void step(Pool pool, int number) {
        act(pool, number);
        pool.step(Scenes.DT);
    }

    private static void act(Pool pool, int number) {
        RigidBody paddle = pool.bodies().get(PADDLE);
        if (number % 50 == 0) {
            paddle.velocity(number % 100 == 0 ? 0.8 : -0.8, 0);
        }
        if (number % 100 == 30) {
            paddle.velocity(0, 0);
        }
        Random random = new Random(number);
        if (number % 7 == 0) {
            RigidBody pushed = loose(pool, random);
            pushed.applyForce(20 * random.nextDouble() - 10, 15, pushed.x() + 0.1, pushed.y());
        }
        if (number % 40 == 11) {
            pool.remove(loose(pool, random));
        }
        if (number % 40 == 25) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.regular(3 + number % 5, 0.4))
                            .at(12 * random.nextDouble() - 6, 6)
                            .spin(4)
                            .material(new Material(1, 0.4, 0.6))
                            .name("late " + number));
        }
        if (number % 120 == 90) {
            loose(pool, random).moveTo(4 * random.nextDouble(), 9, random.nextDouble());
        }
    }

    private static RigidBody loose(Pool pool, Random random) {
        int count = pool.bodies().size() - FIRST_LOOSE;
        return pool.bodies().get(FIRST_LOOSE + random.nextInt(count));
    }
}
