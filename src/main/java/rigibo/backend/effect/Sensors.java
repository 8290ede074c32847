package rigibo.backend.effect;

import java.util.List;

/**
 * Sensors: shapes that touch nothing and report which bodies are inside: coins, doors, goals, the
 * foot of a character. Entries and exits are found along each body's path within the step, so a
 * bullet that passes through is reported as entering and leaving. A sensor detects sleeping and
 * static bodies too, obeys filters, and detects no other sensor.
 *
 * <pre>{@code
 * Pool pool = new Pool(Effects.usual().with(new Sensors()), Accuracy.GAME);
 * RigidBody coin = pool.add(BodyDefinition.fixed(new Circle(0.3)).at(4, 1).sensor());
 * pool.step(1 / 60.0);
 * pool.forEachSensorEvent(event -> System.out.println(event.visitor + " found " + event.sensor));
 * }</pre>
 */
public record Sensors() implements Effect {
    @Override
    public Kind kind() {
        return Kind.SENSORS;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.CONTACTS));
    }
}
