package rigibo.lab.bench.scene;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * Boxes of 1 m that are thrown up and apart and never touch.
 *
 * <p>They need gravity, and contacts too, since every engine has to find out that nothing touches.
 * Nothing turns them and nothing rubs.
 */
final class Flyers {

    private static final Effects EFFECTS = Effects.of(new Gravity(0, -9.81), new Contacts());

    private static final Polygon BOX = Polygon.box(1, 1);

    /** The initial distance between boxes, m; the fastest take more than two steps for it. */
    private static final double SPACING = 2.5;

    /** The time after which the crowd is twice as wide, s. */
    private static final double DOUBLING = 20;

    /** The upward speed, m/s; a box is back after 5 s. */
    private static final double THROW = 24.5;

    private static final int ROWS_PER_COLUMN = 2;

    private Flyers() {}

    /** Makes boxes, twice as many side by side as above each other. */
    static Scene of(int bodies) {
        int columns = (int) Math.ceil(Math.sqrt(ROWS_PER_COLUMN * bodies));
        List<BodyDefinition> boxes = new ArrayList<>();
        for (int i = 0; i < bodies; i++) {
            double x = SPACING * (i % columns - (columns - 1) / 2.0);
            double y = SPACING * (i / columns);
            boxes.add(
                    BodyDefinition.dynamic(BOX)
                            .at(x, y)
                            .velocity(x / DOUBLING, y / DOUBLING + THROW));
        }
        return new Scene(EFFECTS, boxes);
    }
}
