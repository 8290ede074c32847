package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Bodies slide without friction over a floor of forty separate boxes side by side. Truth: the floor
 * is one plane, so speed and height are constant; the edges between the boxes are inside the floor.
 */
final class ButtedBoxes implements Scenes {

    private static final int BOXES = 40;
    private static final double WAY = 34;

    @Override
    public void run(Trial trial) {
        Map<String, Shape> shapes = new LinkedHashMap<>();
        shapes.put("box", Polygon.box(1, 1));
        shapes.put("disc", new Circle(0.5));
        shapes.put("triangle", Polygon.of(-0.5, 0, 0.5, 0, 0, 0.8));
        for (double speed : new double[] {2, 20}) {
            shapes.forEach(
                    (name, shape) -> {
                        trial.variant(name + " at " + speed + " m/s");
                        slide(trial, shape, speed);
                    });
        }
    }

    private static void slide(Trial trial, Shape shape, double speed) {
        WatchedPool pool = trial.earth();
        BodyDefinition box = Solid.fixed(1, 1, 0, 0);
        for (int i = 0; i < BOXES; i++) {
            pool.add(box.at(i, -0.5));
        }
        RigidBody body = pool.add(Solid.of(shape, 0, 0).at(2, height(shape)).velocity(speed, 0));
        double y = body.y();
        while (pool.time() < WAY / speed) {
            pool.step();
            trial.relativeError("speed changed", body.velocityX(), speed, "of v", 1e-6);
            trial.measure("height changed", Math.abs(body.y() - y), "m", Trial.TOLERATED_OVERLAP);
        }
    }

    /** Height of the centre of mass above the lowest point, m. */
    private static double height(Shape shape) {
        if (shape instanceof Circle) {
            return ((Circle) shape).radius();
        }
        Polygon polygon = (Polygon) shape;
        double lowest = 0;
        for (int i = 0; i < polygon.corners(); i++) {
            lowest = Math.min(lowest, polygon.cornerY(i));
        }
        return -lowest;
    }
}
