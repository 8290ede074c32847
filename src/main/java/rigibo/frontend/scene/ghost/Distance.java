package rigibo.frontend.scene.ghost;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;

import java.util.Iterator;

/** Root mean square distances of dynamic bodies, between two pools and within one, m. */
final class Distance {

    private Distance() {}

    /** How far the bodies of a pool are from those in the same places of another's list. */
    static double between(Pool one, Pool other) {
        double sum = 0;
        int count = 0;
        Iterator<RigidBody> others = other.bodies().iterator();
        for (RigidBody body : one.bodies()) {
            if (!others.hasNext()) {
                // Counts differ if the scene adds bodies depending on its state and has added more
                // than its copy.
                break;
            }
            RigidBody twin = others.next();
            if (body.type() == BodyType.DYNAMIC) {
                sum += square(body.x() - twin.x(), body.y() - twin.y());
                count++;
            }
        }
        return count == 0 ? 0 : Math.sqrt(sum / count);
    }

    /** How far the bodies are from their middle; of one body alone, its own radius. */
    static double size(Pool pool) {
        double x = 0;
        double y = 0;
        double radius = 0;
        int count = 0;
        for (RigidBody body : pool.bodies()) {
            if (body.type() == BodyType.DYNAMIC) {
                x += body.x();
                y += body.y();
                radius = Math.max(radius, body.shape().boundingRadius());
                count++;
            }
        }
        double sum = 0;
        for (RigidBody body : pool.bodies()) {
            if (body.type() == BodyType.DYNAMIC) {
                sum += square(body.x() - x / count, body.y() - y / count);
            }
        }
        return count == 0 ? 0 : Math.max(radius, Math.sqrt(sum / count));
    }

    private static double square(double x, double y) {
        return x * x + y * y;
    }
}
