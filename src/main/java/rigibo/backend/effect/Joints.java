package rigibo.backend.effect;

import java.util.List;

/**
 * Bodies can be joined by hinges, rods, springs and other joints. Without this effect {@code
 * Pool.join} throws.
 *
 * <pre>{@code
 * Pool pool = new Pool(Effects.usual().with(new Joints()), Accuracy.GAME);
 * RigidBody hook = pool.add(BodyDefinition.fixed(Polygon.box(0.1, 0.1)));
 * RigidBody bob = pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(1, 0));
 * pool.join(DistanceJoint.rod(hook, 0, 0, bob, 1, 0));
 * pool.step(1 / 60.0);
 * }</pre>
 */
public record Joints() implements Effect {
    @Override
    public Kind kind() {
        return Kind.JOINTS;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.CONTACTS));
    }
}
