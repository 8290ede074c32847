package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Stacks of five to nine boxes of many sizes. */
public final class StackOfFive implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        for (int stack = 0; stack < 5; stack++) {
            double y = 0;
            for (int i = 0; i < 5 + stack; i++) {
                double size = 0.8 - 0.07 * i;
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(size, size))
                                .at(-3.2 + 1.6 * stack, y + size / 2));
                y += size;
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 9.5);
    }
}
