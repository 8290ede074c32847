package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** A force of one's own: a ball on a spring in honey. */
public final class OwnField {

    private OwnField() {}

    /** Prints where the ball is, every half second. */
    public static void main(String[] arguments) {
        Field spring = new Field(at -> at.push(-40 * at.x - at.velocityX, -40 * at.y)); // N
        Pool pool = new Pool(Effects.of(spring), Accuracy.FINE);
        RigidBody ball =
                pool.add(BodyDefinition.dynamic(new Circle(0.1)).mass(2).at(1, 0).velocity(0, 3));
        while (pool.time() < 3) {
            for (int i = 0; i < 30; i++) {
                pool.step(1.0 / 60);
            }
            System.out.printf("%.1f s: (%.3f, %.3f) m%n", pool.time(), ball.x(), ball.y());
        }
    }
}
