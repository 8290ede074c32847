package rigibo.lab.bench.scene;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.World;

import java.util.ArrayList;
import java.util.List;

/**
 * A square drum that turns about its middle, made of four kinematic walls, each its own body.
 * Engines move kinematic bodies along straight lines. So before each step every wall is given the
 * velocity that leads to its true place at the end of the step; errors do not accumulate, and the
 * corners stay closed.
 *
 * @param y of its middle, m; its x is 0
 * @param side from wall to wall inside, m
 * @param spin rad/s, counter-clockwise
 */
record Drum(double y, double side, double spin) implements Driver {

    static final int WALLS = 4;

    /** The thickness of a wall, m: many times the motion of the fastest body in a step. */
    private static final double THICKNESS = 1;

    /** Its walls at time 0. */
    List<BodyDefinition> bodies(Material material) {
        List<BodyDefinition> bodies = new ArrayList<>();
        Polygon wall = Polygon.box(side + 2 * THICKNESS, THICKNESS);
        for (int i = 0; i < WALLS; i++) {
            double angle = angle(i, 0);
            bodies.add(
                    BodyDefinition.kinematic(wall)
                            .at(x(angle), y(angle))
                            .angle(angle)
                            .material(material));
        }
        return bodies;
    }

    /** Turns its walls, which are the world's first bodies, in the next step. */
    @Override
    public void drive(World world, int made) {
        for (int i = 0; i < WALLS; i++) {
            double next = angle(i, (made + 1) * Scene.STEP);
            double velocityX = (x(next) - world.x(i)) / Scene.STEP;
            double velocityY = (y(next) - world.y(i)) / Scene.STEP;
            world.drive(i, velocityX, velocityY, spin);
        }
    }

    private double angle(int wall, double time) {
        return wall * Math.PI / 2 + spin * time;
    }

    /** The x of a wall's middle; the first wall is at the bottom. */
    private double x(double angle) {
        return (side + THICKNESS) / 2 * Math.sin(angle);
    }

    private double y(double angle) {
        return y - (side + THICKNESS) / 2 * Math.cos(angle);
    }
}
