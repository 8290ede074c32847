package rigibo.backend.flight;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldFunction;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Integrator;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

/** A disc of 1 kg that flies through fields, without the other stages of a step. */
final class Thrown {

    final FilledStorage storage;
    final Bodies bodies;
    final Course course;
    final OpenFlight flight;

    Thrown(Accuracy accuracy, double drag, FieldFunction... fields) {
        this(accuracy, drag, 1, fields);
    }

    Thrown(Accuracy accuracy, double drag, int count, FieldFunction... fields) {
        FieldFunction all =
                at -> {
                    for (FieldFunction field : fields) {
                        field.act(at);
                    }
                };
        Effect[] effects = {new Field(all), new Drag()};
        storage = new FilledStorage(accuracy, effects);
        bodies = storage.bodies;
        for (int i = 0; i < count; i++) {
            storage.add(
                    BodyDefinition.dynamic(new Circle(1))
                            .mass(1)
                            .at(1, 2)
                            .velocity(3, 4)
                            .material(Material.DEFAULT.drag(drag)));
        }
        Effects declared = Effects.of(effects);
        course = new Course(storage.data, new ChangingForces(declared), accuracy);
        flight = new OpenFlight(storage.data, course);
    }

    /** Makes a step as the stages do, under constant accelerations besides the fields. */
    void step(double dt, double ax, double ay) {
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            bodies.accelerationX[slot] = ax;
            bodies.accelerationY[slot] = ay;
        }
        course.begin(dt);
        flight.fly(dt);
        storage.data.time += dt;
    }

    /** The accuracy of a method with one substep a step. */
    static Accuracy by(Integrator method) {
        return Accuracy.DRAFT.withIntegrator(method);
    }
}
