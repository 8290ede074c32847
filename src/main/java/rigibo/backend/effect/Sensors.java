package rigibo.backend.effect;

/**
 * Shapes that touch nothing and tell who is inside: coins, doors, goals, the foot of a character.
 * Who entered, who is inside and who left is read after the step, along each body's way within it,
 * so that a bullet that passed through entered and left. A sensor sees sleeping and static visitors
 * too, obeys filters and sees no other sensor.
 *
 * <pre>{@code
 * Pool pool = new Pool(Effects.usual().with(new Sensors()), Accuracy.GAME);
 * RigidBody coin = pool.add(BodyDefinition.fixed(new Circle(0.3)).at(4, 1).sensor());
 * pool.step(1 / 60.0);
 * pool.forEachSensorEvent(event -> System.out.println(event.visitor + " found " + event.sensor));
 * }</pre>
 */
public record Sensors() implements Effect {}
