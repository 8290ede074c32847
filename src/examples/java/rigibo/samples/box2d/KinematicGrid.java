package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** A grid of 225 boxes, driven as one body. */
public final class KinematicGrid implements Exhibit {
    @Override
    public void build(Pool pool) {

        List<Part> grid = new ArrayList<>();
        for (int i = 0; i < 225; i++) {
            grid.add(Part.of(Polygon.box(0.3, 0.3)).at(0.45 * (i % 15 - 7), 0.45 * (i / 15 - 7)));
        }
        pool.add(BodyDefinition.kinematic(Compound.of(grid)).at(0, 4).spin(1));
        for (int i = 0; i < 40; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.12))
                            .at(-2 + 0.4 * (i % 10), 8.6 + 0.4 * (i / 10)));
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 13);
    }
}
