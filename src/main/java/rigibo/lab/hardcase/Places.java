package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;

import java.util.List;

/** The former places of some bodies. */
final class Places {

    private final List<RigidBody> bodies;
    private final double[] x;
    private final double[] y;

    /** Records the present places. */
    Places(List<RigidBody> bodies) {
        this.bodies = bodies;
        x = bodies.stream().mapToDouble(RigidBody::x).toArray();
        y = bodies.stream().mapToDouble(RigidBody::y).toArray();
    }

    /** The largest difference between numbers of equal index. */
    static double farthestApart(double[] some, double[] others) {
        double most = 0;
        for (int i = 0; i < some.length; i++) {
            most = Math.max(most, Math.abs(some[i] - others[i]));
        }
        return most;
    }

    /** The largest distance of a body from its recorded place, m. */
    double farthest() {
        double most = 0;
        for (int i = 0; i < x.length; i++) {
            RigidBody body = bodies.get(i);
            most = Math.max(most, Math.hypot(body.x() - x[i], body.y() - y[i]));
        }
        return most;
    }
}
