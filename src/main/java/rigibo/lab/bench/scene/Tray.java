package rigibo.lab.bench.scene;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.World;

import java.util.ArrayList;
import java.util.List;

/**
 * A closed box of four kinematic walls, the scene's first bodies, that is shaken from side to side:
 * the x of its middle is a·sin(2πft). Before each step a wall is given the velocity that leads to
 * its true place at the end of the step.
 *
 * @param width inside, m
 * @param height inside, m; its floor's top is at y = 0
 * @param amplitude a, m
 * @param hertz f, 1/s
 */
record Tray(double width, double height, double amplitude, double hertz) implements Driver {

    /** The thickness of a wall, m, more than the box moves in a step. */
    private static final double THICKNESS = 2;

    /** Its walls at time 0: floor, ceiling, left, right. */
    List<BodyDefinition> bodies(Material material) {
        Polygon level = Polygon.box(width + 2 * THICKNESS, THICKNESS);
        Polygon upright = Polygon.box(THICKNESS, height);
        List<BodyDefinition> walls = new ArrayList<>();
        walls.add(BodyDefinition.kinematic(level).at(0, -THICKNESS / 2));
        walls.add(BodyDefinition.kinematic(level).at(0, height + THICKNESS / 2));
        walls.add(BodyDefinition.kinematic(upright).at(left(), height / 2));
        walls.add(BodyDefinition.kinematic(upright).at(-left(), height / 2));
        return walls.stream().map(wall -> wall.material(material)).toList();
    }

    @Override
    public void drive(World world, int made) {
        double next = amplitude * Math.sin(2 * Math.PI * hertz * (made + 1) * Scene.STEP);
        double[] places = {0, 0, left(), -left()};
        for (int wall = 0; wall < places.length; wall++) {
            world.drive(wall, (places[wall] + next - world.x(wall)) / Scene.STEP, 0, 0);
        }
    }

    /** The x of the left wall's middle while the box is centred, m. */
    private double left() {
        return -(width + THICKNESS) / 2;
    }
}
