package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.StepReport;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** The engine in a few lines: a crate falls on a floor, tumbles and comes to rest. */
public final class FallingCrate {

    private FallingCrate() {}

    /** Prints where the crate is, every second. */
    public static void main(String[] arguments) {
        // README begins
        Pool pool = new Pool(); // gravity, contacts, rotation, friction, restitution, sleep
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
        RigidBody crate =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(1, 1))
                                .at(0, 5)
                                .angle(0.1)
                                .velocity(2, 0)
                                .material(new Material(700, 0.5, 0.2)));
        while (crate.isAwake()) {
            StepReport report = pool.step(1.0 / 60);
            if (report.impacts() > 0) {
                System.out.printf("%.2f s: %s%n", pool.time(), crate);
            }
        }
        // README ends
    }
}
