package rigibo.backend.flight;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** Simultaneous impacts at one time of a step, without the flight that leads to them. */
final class OneInstant {

    final Air air = new Air(Accuracy.GAME);
    final Trajectories paths = new Trajectories(air.bodies);
    final FlightImpacts impacts =
            new FlightImpacts(air.storage.data, air.narrowphase, Accuracy.GAME, paths, null);

    /** Adds a floor with its top at y = 0, in slot 0. */
    void layFloor(double elasticity) {
        air.add(
                BodyDefinition.fixed(Polygon.box(20, 1))
                        .at(0, -0.5)
                        .material(new Material(1, 0, elasticity)));
    }

    /** Begins a step of dt seconds with the bodies that were added. */
    void begin(double dt) {
        air.meet(dt);
        paths.begin();
        impacts.reserve();
    }

    /** Resolves the impacts of pairs at a time in s within a step of dt seconds. */
    void strike(double time, double dt, int... pairs) {
        impacts.strike(pairs, pairs.length, pairs[0], time, dt);
    }
}
