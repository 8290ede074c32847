package rigibo.lab.bench.scene;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Boxes and discs of many sizes that fall, in rows above each other, at any angle.
 *
 * <p>They call for gravity, contacts, rotation, friction, the little restitution that stones have,
 * and continuous impacts, since the last rows land faster than a body's width in a step.
 */
public enum Crowd {
    BOXES(0),
    DISCS(1),
    MIXED(0.5);

    /** The effects of a crowd. */
    public static final Effects EFFECTS =
            Effects.of(
                    new Gravity(0, -9.81),
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new ContinuousImpacts());

    /** The material of the bodies and of their trough. */
    public static final Material STONE = new Material(1, 0.6, 0.1);

    /** The initial distance between bodies, m; the largest have room at any angle. */
    private static final double SPACING = 1.2;

    /** The area of the trough that a body at rest takes, gaps included, m². */
    private static final double AREA = 0.45;

    /** The width of the narrowest trough, m: room for two bodies side by side. */
    private static final double NARROWEST = 2.6;

    private static final double WALL = 2;

    /** The height of the trough above the highest body at the start, m. */
    private static final double MARGIN = 10;

    private final double discs;

    /** A crowd with a share of discs. */
    Crowd(double discs) {
        this.discs = discs;
    }

    /** Bodies above a trough that is about as wide as their heap will be high. */
    public List<BodyDefinition> rain(int count, long seed) {
        double width = Math.max(NARROWEST, Math.sqrt(AREA * count));
        int columns = (int) (width / SPACING);
        double top = (count / columns + 1) * SPACING + MARGIN;
        List<BodyDefinition> bodies = new ArrayList<>();
        Polygon side = Polygon.box(WALL, top);
        bodies.add(BodyDefinition.fixed(Polygon.box(width + 2 * WALL, WALL)).at(0, -WALL / 2));
        bodies.add(BodyDefinition.fixed(side).at(-(width + WALL) / 2, top / 2));
        bodies.add(BodyDefinition.fixed(side).at((width + WALL) / 2, top / 2));
        bodies.addAll(rows(count, columns, SPACING, seed));
        return bodies.stream().map(body -> body.material(STONE)).toList();
    }

    /** Bodies in rows about x = 0, with the lowest row at a height in m. */
    public List<BodyDefinition> rows(int count, int columns, double height, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double x = SPACING * (i % columns - (columns - 1) / 2.0);
            double y = height + SPACING * (i / columns);
            bodies.add(body(random).at(x, y).angle(2 * Math.PI * random.nextDouble()));
        }
        return bodies.stream().map(body -> body.material(STONE)).toList();
    }

    /** A box of 0.5 to 0.9 m by 0.3 to 0.7 m, or a disc of 0.4 to 0.7 m across. */
    private BodyDefinition body(SplittableRandom random) {
        boolean isDisc = random.nextDouble() < discs;
        double across = random.nextDouble();
        double up = random.nextDouble();
        return BodyDefinition.dynamic(
                isDisc
                        ? new Circle(0.2 + 0.15 * across)
                        : Polygon.box(0.5 + 0.4 * across, 0.3 + 0.4 * up));
    }
}
