package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Three teams: each stands on the floor and passes through the others. */
public final class FilterShapes implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        for (int team = 1; team <= 3; team++) {
            int category = 1 << team;
            Filter own = Filter.ALL.category(category).mask(1 | category);
            for (int i = 0; i < 4; i++) {
                double size = 0.5 + 0.3 * team;
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(size, size))
                                .at(0.5 * team - 1 + 0.05 * i, 0.6 + 1.4 * i)
                                .filter(own)
                                .material(
                                        new Material(
                                                1, team == 3 ? 0.03 : 0.5, team == 2 ? 0.6 : 0)));
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}
