package rigibo.lab.bench.scene;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.Link;

import java.util.ArrayList;
import java.util.List;

/** Crowds of joined bodies. */
public final class Assemblies {

    /** The effects of a crowd, and joints. */
    public static final Effects EFFECTS = Crowd.EFFECTS.with(new Joints());

    private static final Material STUFF = new Material(1, 0.6, 0);

    /** The limits of a ragdoll's hinges, rad in either direction. */
    private static final double BEND = 0.8;

    /** The dry friction of a ragdoll's hinges, N·m. */
    private static final double STIFFNESS = 1;

    /** The distance between ragdolls in a row, and between rows, m. */
    private static final double BESIDE = 2;

    private static final double ABOVE = 2.2;

    private final List<BodyDefinition> bodies = new ArrayList<>();
    private final List<Link> links = new ArrayList<>();

    private Assemblies() {}

    private Scene scene() {
        return new Scene(EFFECTS, bodies, links);
    }

    private int add(BodyDefinition body) {
        bodies.add(body.material(STUFF));
        return bodies.size() - 1;
    }

    private int box(double x, double y, double width, double height) {
        return add(BodyDefinition.dynamic(Polygon.box(width, height)).at(x, y));
    }

    private void ground(double width) {
        add(BodyDefinition.fixed(Polygon.box(width, 2)).at(0, -1));
    }

    /** A square net of hinged discs that hangs by its upper corners. */
    public static Scene grid(int side) {
        Assemblies net = new Assemblies();
        Shape disc = new Circle(0.1);
        double top = 0.5 * side + 5;
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                boolean isHook = row == 0 && column % (side - 1) == 0;
                double x = 0.5 * column;
                double y = top - 0.5 * row;
                BodyDefinition knot =
                        isHook ? BodyDefinition.fixed(disc) : BodyDefinition.dynamic(disc);
                int here = net.add(knot.at(x, y).group(1));
                if (column > 0) {
                    net.links.add(Link.hinge(here - 1, here, x - 0.25, y));
                }
                if (row > 0) {
                    net.links.add(Link.hinge(here - side, here, x, y + 0.25));
                }
            }
        }
        return net.scene();
    }

    /** Ragdolls that fall on each other between two walls. */
    public static Scene ragdolls(int count) {
        Assemblies pile = new Assemblies();
        int beside = Math.max(1, (int) Math.round(Math.sqrt(count)));
        double half = BESIDE * (beside + 1) / 2;
        double high = ABOVE * (count / beside + 2);
        pile.ground(2 * half + 4);
        for (int side = -1; side <= 1; side += 2) {
            pile.add(BodyDefinition.fixed(Polygon.box(1, high)).at(side * (half + 0.5), high / 2));
        }
        for (int i = 0; i < count; i++) {
            int row = i / beside;
            double x = BESIDE * (i % beside - (beside - 1) / 2.0) + 0.3 * (row % 3 - 1);
            pile.ragdoll(x, 2 + ABOVE * row);
        }
        return pile.scene();
    }

    /**
     * Ragdolls that fall down eight stairs.
     *
     * @param higher by how much they begin higher, m
     */
    public static Scene stairs(int count, double higher) {
        Assemblies fall = new Assemblies();
        fall.ground(60);
        for (int step = 0; step < 8; step++) {
            fall.add(BodyDefinition.fixed(Polygon.box(1, 8 - step)).at(step - 4, (8 - step) / 2.0));
        }
        for (int i = 0; i < count; i++) {
            fall.ragdoll(-3.5 + BESIDE * (i % 4), higher + 11 - i % 4 + ABOVE * (i / 4));
        }
        return fall.scene();
    }

    /** Eleven bodies on ten hinges with limits and a brake; x and y of its chest. */
    private void ragdoll(double x, double y) {
        int chest = box(x, y, 0.4, 0.3);
        int belly = box(x, y - 0.3, 0.35, 0.3);
        bend(chest, belly, x, y - 0.15);
        int head = add(BodyDefinition.dynamic(new Circle(0.15)).at(x, y + 0.3));
        bend(chest, head, x, y + 0.15);
        for (int side = -1; side <= 1; side += 2) {
            int arm = box(x + side * 0.35, y + 0.1, 0.3, 0.1);
            bend(chest, arm, x + side * 0.2, y + 0.1);
            int hand = box(x + side * 0.65, y + 0.1, 0.3, 0.09);
            bend(arm, hand, x + side * 0.5, y + 0.1);
            int thigh = box(x + side * 0.1, y - 0.65, 0.14, 0.4);
            bend(belly, thigh, x + side * 0.1, y - 0.45);
            int shin = box(x + side * 0.1, y - 1.05, 0.12, 0.4);
            bend(thigh, shin, x + side * 0.1, y - 0.85);
        }
    }

    private void bend(int a, int b, double x, double y) {
        links.add(Link.hinge(a, b, x, y).limits(-BEND, BEND).motor(0, STIFFNESS));
    }

    /** Bridges one above the other, with discs that fall on each. */
    public static Scene bridges(int count, int planks) {
        Assemblies all = new Assemblies();
        for (int i = 0; i < count; i++) {
            all.bridge(planks, 8 * i);
        }
        return all.scene();
    }

    private void bridge(int planks, double y) {
        Shape plank = Polygon.box(0.5, 0.125);
        double left = -0.25 * planks;
        int first = add(BodyDefinition.fixed(new Circle(0.05)).at(left - 0.05, y));
        int before = first;
        for (int i = 0; i < planks; i++) {
            double x = left + 0.5 * i;
            int here = add(BodyDefinition.dynamic(plank).at(x + 0.25, y));
            links.add(Link.hinge(before, here, x, y));
            before = here;
        }
        double right = left + 0.5 * planks;
        int last = add(BodyDefinition.fixed(new Circle(0.05)).at(right + 0.05, y));
        links.add(Link.hinge(before, last, right, y));
        for (int i = 0; i < planks / 4; i++) {
            add(BodyDefinition.dynamic(new Circle(0.25)).at(left / 2 + 1.01 * i, y + 2));
        }
    }

    /** Doors seen from above; they are thrown open, and a damped spring pulls each shut. */
    public static Scene doors(int count) {
        Assemblies all = new Assemblies();
        for (int i = 0; i < count; i++) {
            double x = 4 * (i % 10);
            double y = 4 * (i / 10);
            int frame = all.add(BodyDefinition.fixed(Polygon.box(0.2, 0.2)).at(x, y));
            double spin = 2 + 0.1 * i;
            int door =
                    all.add(
                            BodyDefinition.dynamic(Polygon.box(2, 0.2))
                                    .at(x + 1.1, y)
                                    .velocity(0, 1.1 * spin)
                                    .spin(spin));
            all.links.add(Link.hinge(frame, door, x, y).limits(-2, 2));
            all.links.add(Link.rod(frame, x, y - 1, door, x + 1.1, y).spring(1, 0.7));
        }
        return all.scene();
    }

    /** Cars with two driven wheels on springs that drive over bumps. */
    public static Scene cars(int count) {
        Assemblies all = new Assemblies();
        double length = 6.0 * count + 200;
        all.add(BodyDefinition.fixed(Polygon.box(length, 2)).at(length / 2 - 10, -1));
        for (int i = 0; i < length / 10 - 3; i++) {
            all.add(BodyDefinition.fixed(new Circle(1)).at(10 + 10 * i, -0.8));
        }
        for (int i = 0; i < count; i++) {
            all.car(6.0 * i);
        }
        return all.scene();
    }

    private void car(double x) {
        int chassis = box(x, 0.9, 3, 0.6);
        for (int side = -1; side <= 1; side += 2) {
            double at = x + side;
            int wheel = add(BodyDefinition.dynamic(new Circle(0.4)).at(at, 0.4));
            links.add(Link.wheel(chassis, wheel, at, 0.4, at, 1.4).spring(4, 0.7).motor(-10, 10));
        }
    }
}
