package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Nine drums of capsules. */
public final class ManyTumblers implements Exhibit {
    @Override
    public void build(Pool pool) {

        for (int drum = 0; drum < 9; drum++) {
            double x = 2.8 * (drum % 3 - 1);
            double y = 4 + 2.8 * (drum / 3 - 1);
            pool.add(BodyDefinition.kinematic(Tumbler.drum(1.6)).at(x, y).spin(0.8));
            for (int i = 0; i < 12; i++) {
                pool.add(
                        BodyDefinition.dynamic(new Capsule(0.12, 0.07))
                                .at(x - 0.5 + 0.4 * (i % 4), y - 0.4 + 0.3 * (i / 4)));
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}
