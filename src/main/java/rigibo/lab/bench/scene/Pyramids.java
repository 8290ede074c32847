package rigibo.lab.bench.scene;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * Pyramids of boxes of 1 m that touch each other and a floor. Box2D 2.x and its translations keep
 * polygons a centimetre or two apart and first push touching boxes apart. No distance suits all
 * engines, and the engines' own samples begin like this.
 *
 * <p>The pyramids need gravity, contacts, rotation and the friction without which they would slide
 * apart. Nothing falls or bounces, so they need neither restitution nor continuous impacts. Sleep
 * is declared only where waking is measured.
 */
final class Pyramids {

    private static final Effects EFFECTS =
            Effects.of(new Gravity(0, -9.81), new Contacts(), new Rotation(), new Friction());

    private static final Material STONE = new Material(1, 0.6, 0);

    /** The width of the floor beside each pyramid, m. */
    private static final double MARGIN = 5;

    /** The distance between pyramids of a field, m, more than boxes pushed apart need. */
    private static final double GAP = 1;

    /** The distance between the tip of a pyramid and the floor above it, m. */
    private static final double HEADROOM = 3;

    private Pyramids() {}

    /** One pyramid with a number of boxes at its base. */
    static Scene one(int base) {
        return field(1, 1, base);
    }

    /**
     * One pyramid that loses the middle box of its base after a number of steps. Asleep or awake,
     * it has to find the same new balance.
     */
    static Scene undermined(int base, int steps, Effects effects) {
        List<BodyDefinition> bodies = one(base).bodies();
        int firstBox = 1;
        return new Scene(effects, bodies, new Driver.None(), new Loss(firstBox + base / 2, steps));
    }

    /** The effects of a pyramid, and sleep. */
    static Effects withSleep() {
        return EFFECTS.with(new Sleep());
    }

    /** The effects of a pyramid. */
    static Effects withoutSleep() {
        return EFFECTS;
    }

    /** Storeys one above the other, each a floor with pyramids side by side. */
    static Scene field(int storeys, int beside, int base) {
        List<BodyDefinition> bodies = new ArrayList<>();
        double width = beside * (base + GAP);
        Polygon floor = Polygon.box(width + 2 * MARGIN, 1);
        BodyDefinition box = Solid.box(1, 1).material(STONE);
        for (int storey = 0; storey < storeys; storey++) {
            double ground = storey * (base + HEADROOM);
            bodies.add(BodyDefinition.fixed(floor).at(0, ground - 0.5).material(STONE));
            for (int i = 0; i < beside; i++) {
                double x = (base + GAP) * (i - (beside - 1) / 2.0);
                Solid.pyramid(box, base, 1, 0)
                        .map(one -> one.at(x + one.x(), ground + one.y()))
                        .forEach(bodies::add);
            }
        }
        return new Scene(EFFECTS, bodies);
    }
}
