package rigibo.examples;

import rigibo.backend.Explosion;
import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Crates stand round a spot; a blast drives them apart. The right button sets off another. */
public final class Blast implements Exhibit {

    static final double AT = 1; // s
    private static final Material CRATE = new Material(50, 0.5, 0.1);
    private boolean isOver;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        for (int side = -1; side <= 1; side += 2) {
            pool.add(BodyDefinition.fixed(Polygon.box(0.4, 7)).at(side * 5, 3.5));
            for (int i = 0; i < 12; i++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                .at(side * (0.7 + 0.55 * (i / 6)), 0.25 + 0.5 * (i % 6))
                                .material(CRATE));
            }
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        if (!isOver && pool.time() >= AT) {
            isOver = true;
            act(pool, 0, 0.5);
        }
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.explode(Explosion.at(x, y).radius(1.5).falloff(2).impulsePerMetre(150));
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }

    /** Prints momentum and energy before and after. */
    public static void main(String[] arguments) {
        Blast example = new Blast();
        Pool pool = example.open();
        for (int i = 0; i < 2; i++) {
            example.run(pool, 1.02);
            System.out.printf(
                    "%.2f s: %.3g N·s to the right, %.1f J%n",
                    pool.time(), pool.momentumX(), pool.kineticEnergy());
        }
    }
}
