package rigibo.lab.ablation.probe;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

import java.util.List;
import java.util.function.Consumer;

/** Joins every user of a pool with its partner, the next body, in its first step in the pool. */
final class Joiner implements Consumer<Pool> {

    private final int users;
    private Pool joined;

    Joiner(int users) {
        this.users = users;
    }

    @Override
    public void accept(Pool pool) {
        if (joined == pool) {
            return;
        }
        joined = pool;
        List<RigidBody> bodies = pool.bodies();
        for (int i = 0; i < users; i++) {
            RigidBody user = bodies.get(2 * i);
            RigidBody partner = bodies.get(2 * i + 1);
            pool.join(
                    DistanceJoint.rod(user, user.x(), user.y(), partner, partner.x(), partner.y()));
        }
    }
}
