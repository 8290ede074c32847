package rigibo.lab.bench.scene;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * Boxes of 1 m that were thrown up and apart and never touch.
 *
 * <p>They call for gravity and for contacts: that nothing meets is known afterwards only, and every
 * engine has to look. Nothing turns them, nothing rubs.
 */
final class Flyers {

    private static final Effects EFFECTS = Effects.of(new Gravity(0, -9.81), new Contacts());

    private static final Polygon BOX = Polygon.box(1, 1);

    /** From one to the next as they begin, m: between them the fastest need more than two steps. */
    private static final double SPACING = 2.5;

    /** As much again to both sides after so many s. */
    private static final double DOUBLING = 20;

    /** m/s: back where it was thrown after 5 s. */
    private static final double THROW = 24.5;

    private static final int ROWS_PER_COLUMN = 2;

    private Flyers() {}

    /** Twice as many beside each other as above. */
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
