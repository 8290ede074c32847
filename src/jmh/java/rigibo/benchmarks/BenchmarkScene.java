package rigibo.benchmarks;

import rigibo.backend.Pool;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** A scene that stays as it is, so that every step does equal work. */
public enum BenchmarkScene {
    /** 500 discs at rest in a trough of 10 m, without sleep. */
    HEAP {
        @Override
        Pool make() {
            Pool pool = ground();
            pool.add(BodyDefinition.fixed(Polygon.box(1, 60)).at(-5.5, 30));
            pool.add(BodyDefinition.fixed(Polygon.box(1, 60)).at(5.5, 30));
            for (int i = 0; i < 500; i++) {
                // Every second row is shifted by half a gap, since discs exactly above each other
                // would stay so.
                double x = -4.5 + i % 16 * 0.58 + i / 16 % 2 * 0.25;
                pool.add(BodyDefinition.dynamic(new Circle(0.25)).at(x, 0.5 + i / 16 * 0.55));
            }
            return settled(pool);
        }
    },
    /** 210 boxes, 20 at the base. */
    PYRAMID {
        @Override
        Pool make() {
            Pool pool = ground();
            for (int row = 0; row < 20; row++) {
                for (int i = 0; i < 20 - row; i++) {
                    double x = 1.1 * (i - (20 - row) / 2.0);
                    pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(x, row + 0.5));
                }
            }
            return settled(pool);
        }
    },
    /**
     * 20,000 boxes that fly apart, so slowly that no step brings two together: their speeds in m/s
     * are a twentieth of their distances in m from the middle.
     */
    FREE {
        @Override
        Pool make() {
            Pool pool = new Pool(EFFECTS.without(Gravity.class), Accuracy.GAME);
            for (int i = 0; i < 20_000; i++) {
                double x = 2 * (i % 200 - 99.5);
                double y = 2 * (i / 200 - 49.5);
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(1, 1))
                                .at(x, y)
                                .velocity(x / 20, y / 20));
            }
            return pool;
        }
    };

    static final double STEP = 1.0 / 60;

    private static final Effects EFFECTS =
            Effects.of(
                    new Gravity(0, -9.81),
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new ContinuousImpacts());

    /** Steps after which falling bodies are at rest: ten seconds. */
    private static final int SETTLING = 600;

    abstract Pool make();

    private static Pool ground() {
        Pool pool = new Pool(EFFECTS, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5));
        return pool;
    }

    private static Pool settled(Pool pool) {
        for (int i = 0; i < SETTLING; i++) {
            pool.step(STEP);
        }
        return pool;
    }
}
