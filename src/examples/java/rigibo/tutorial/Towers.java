package rigibo.tutorial;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** Chapter 6: workers share the steps of many towers. */
public final class Towers {

    static final double STEP = 1.0 / 60; // s
    static final double GRAVITY = 9.81; // m/s²
    static final int TOWERS = 40;
    static final int STOREYS = 5;

    private Towers() {}

    /** Towers of boxes in a row. Nothing sleeps, so that every step has work to share. */
    static Pool open() {
        Pool pool = new Pool(Effects.usual().without(Sleep.class), Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(2 * TOWERS + 2, 1)).at(0, -0.5).name("floor"));
        for (int tower = 0; tower < TOWERS; tower++) {
            for (int storey = 0; storey < STOREYS; storey++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(1, 0.5))
                                .at(2 * tower - TOWERS + 1, 0.5 * storey + 0.26)
                                .mass(10));
            }
        }
        return pool;
    }

    /** Makes two seconds of steps with some workers, and returns the pool. */
    static Pool run(int workers) {
        Pool pool = open();
        pool.workers(workers);
        for (int i = 0; i < 120; i++) {
            pool.step(STEP);
        }
        pool.close();
        return pool;
    }

    /** The load on the floor, N: the forces of its contacts in the last step. */
    static double carried(Pool pool) {
        RigidBody floor = pool.bodies().get(0);
        double[] sum = {0};
        pool.forEachContact(
                contact -> {
                    if (contact.a == floor || contact.b == floor) {
                        sum[0] += contact.impulse / STEP;
                    }
                });
        return sum[0];
    }

    /** Prints whether the number of workers changes a bit, and what the floor carries. */
    public static void main(String[] arguments) {
        Pool alone = run(1);
        for (int workers = 2; workers <= 4; workers++) {
            boolean isSame = run(workers).stateHash() == alone.stateHash();
            System.out.printf("%d workers, the same bits: %b%n", workers, isSame);
        }
        double weight = TOWERS * STOREYS * 10 * GRAVITY;
        System.out.printf("the floor carries %.0f N, by formula %.0f N%n", carried(alone), weight);
    }
}
