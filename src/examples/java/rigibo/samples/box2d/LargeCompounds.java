package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** Bodies of twenty-five boxes each on a floor of a hundred. */
public final class LargeCompounds implements Exhibit {
    @Override
    public void build(Pool pool) {

        List<Part> floor = new ArrayList<>();
        for (int i = 0; i < 100; i++) {
            floor.add(Part.of(Polygon.box(0.5, 0.5)).at(0.5 * (i % 25 - 12), 0.5 * (i / 25) - 2));
        }
        pool.add(BodyDefinition.fixed(Compound.of(floor)).at(0, -1));
        List<Part> block = new ArrayList<>();
        for (int i = 0; i < 25; i++) {
            block.add(Part.of(Polygon.box(0.3, 0.3)).at(0.3 * (i % 5), 0.3 * (i / 5)));
        }
        for (int i = 0; i < 12; i++) {
            pool.add(
                    BodyDefinition.dynamic(Compound.of(block))
                            .at(-2.7 + 1.8 * (i % 4), 1 + 1.9 * (i / 4))
                            .angle(0.1 * i));
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 11);
    }
}
