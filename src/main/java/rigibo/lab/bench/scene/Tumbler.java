package rigibo.lab.bench.scene;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/**
 * Boxes of 0.25 m that tumble in a drum of 20 m, which turns by 25° per second.
 *
 * <p>They need gravity, contacts, rotation and friction, and continuous impacts, since a box that
 * falls through half of the drum moves by its own width in a step. They do not bounce.
 */
public final class Tumbler {

    private static final Effects EFFECTS =
            Effects.of(
                    new Gravity(0, -9.81),
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new ContinuousImpacts());

    private static final Material STONE = new Material(1, 0.6, 0);
    private static final Polygon BOX = Polygon.box(0.25, 0.25);

    /** The initial distance between boxes, m. */
    private static final double SPACING = 0.4;

    /** The initial distance between the boxes and the walls, m. */
    private static final double MARGIN = 1.2;

    /** The height of the drum's middle, m, so that no wall is ever below y = 0. */
    private static final double HEIGHT_BY_SIDE = 0.8;

    private static final double SPIN = Math.toRadians(25);

    private Tumbler() {}

    /** A square of boxes with a number of columns. */
    public static Scene of(int columns) {
        double side = SPACING * (columns - 1) + 2 * MARGIN;
        Drum drum = new Drum(HEIGHT_BY_SIDE * side, side, SPIN);
        List<BodyDefinition> bodies = new ArrayList<>(drum.bodies(STONE));
        double first = -SPACING * (columns - 1) / 2;
        for (int row = 0; row < columns; row++) {
            for (int i = 0; i < columns; i++) {
                bodies.add(
                        BodyDefinition.dynamic(BOX)
                                .at(first + SPACING * i, drum.y() + first + SPACING * row)
                                .material(STONE));
            }
        }
        return new Scene(EFFECTS, bodies, drum);
    }
}
