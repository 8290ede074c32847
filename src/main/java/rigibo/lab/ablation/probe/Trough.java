package rigibo.lab.ablation.probe;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/** A floor and two walls. */
final class Trough {

    private static final double HEIGHT = 100;

    private Trough() {}

    /** One of an inner width in m, its floor at y = 0; a list that may be added to. */
    static List<BodyDefinition> of(double width) {
        List<BodyDefinition> parts = new ArrayList<>();
        parts.add(BodyDefinition.fixed(Polygon.box(width + 2, 1)).at(0, -0.5));
        for (int side : new int[] {-1, 1}) {
            parts.add(
                    BodyDefinition.fixed(Polygon.box(1, HEIGHT))
                            .at(side * (width + 1) / 2, HEIGHT / 2 - 1));
        }
        return parts;
    }
}
