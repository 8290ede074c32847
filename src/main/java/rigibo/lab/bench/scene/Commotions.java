package rigibo.lab.bench.scene;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * Structures that are set into motion. All declare the effects of a {@link Crowd}; the struck
 * pyramid also declares thrust.
 */
public final class Commotions {

    private static final double FLOOR = 400;
    private static final Polygon BOX = Polygon.box(1, 1);

    private Commotions() {}

    /** A pyramid that settles, from equal vertical gaps in m. */
    public static Scene settling(int base, double gap) {
        List<BodyDefinition> bodies = floor();
        Solid.pyramid(Solid.box(1, 1), base, 1, gap).forEach(bodies::add);
        return scene(bodies);
    }

    /** A pyramid whose foot is struck each second; the impulse would give a box 10 m/s. */
    public static Scene struck(int base) {
        List<BodyDefinition> bodies = floor();
        Solid.pyramid(Solid.box(1, 1), base, 1, 0).forEach(bodies::add);
        double impulse = 10 * bodies.get(1).massProperties().mass();
        Effects effects = Crowd.EFFECTS.with(new Thrust());
        return new Scene(effects, stone(bodies), new Striker(1, impulse, 60));
    }

    /** Towers of boxes side by side, the topmost of each pushed to the right at 2 m/s. */
    public static Scene towers(int towers, int storeys) {
        List<BodyDefinition> bodies = floor();
        for (int tower = 0; tower < towers; tower++) {
            double x = 4 * (tower - (towers - 1) / 2.0);
            for (int storey = 0; storey < storeys; storey++) {
                double push = storey == storeys - 1 ? 2 : 0;
                bodies.add(BodyDefinition.dynamic(BOX).at(x, storey + 0.5).velocity(push, 0));
            }
        }
        return scene(bodies);
    }

    /** Boxes on a belt of 3 m/s that carries them against a wall. */
    public static Scene belt(int boxes) {
        List<BodyDefinition> bodies = new ArrayList<>();
        bodies.add(BodyDefinition.kinematic(Polygon.box(FLOOR, 2)).at(0, -1));
        bodies.add(BodyDefinition.fixed(Polygon.box(2, 40)).at(31, 20));
        bodies.addAll(Crowd.BOXES.rows(boxes, boxes / 4, 0.8, 5));
        return new Scene(Crowd.EFFECTS, stone(bodies), new Belt(3));
    }

    /** Boxes in a closed box that is shaken at 6 g and 3 Hz. */
    public static Scene shaken(int boxes) {
        int columns = (int) Math.ceil(Math.sqrt(boxes));
        double side = 1.2 * columns + 1;
        double pulsation = 2 * Math.PI * 3;
        Tray tray = new Tray(side, 1.5 * side, 6 * 9.81 / (pulsation * pulsation), 3);
        List<BodyDefinition> bodies = new ArrayList<>(tray.bodies(Crowd.STONE));
        bodies.addAll(Crowd.BOXES.rows(boxes, columns, 1, 6));
        return new Scene(Crowd.EFFECTS, stone(bodies), tray);
    }

    /** Rods of 2 m by 0.02 m that fall onto each other crosswise. */
    public static Scene rods(int rods) {
        List<BodyDefinition> bodies = floor();
        Polygon rod = Polygon.box(2, 0.02);
        int columns = 6;
        for (int i = 0; i < rods; i++) {
            int row = i / columns;
            double x = 2.1 * (i % columns - (columns - 1) / 2.0) + 0.5 * (row % 3);
            double lean = row % 2 == 0 ? 0.2 : -0.2;
            bodies.add(BodyDefinition.dynamic(rod).at(x, 1 + 0.5 * row).angle(lean));
        }
        return scene(bodies);
    }

    private static List<BodyDefinition> floor() {
        List<BodyDefinition> bodies = new ArrayList<>();
        bodies.add(BodyDefinition.fixed(Polygon.box(FLOOR, 2)).at(0, -1));
        return bodies;
    }

    private static Scene scene(List<BodyDefinition> bodies) {
        return new Scene(Crowd.EFFECTS, stone(bodies));
    }

    private static List<BodyDefinition> stone(List<BodyDefinition> bodies) {
        return bodies.stream().map(body -> body.material(Crowd.STONE)).toList();
    }
}
