package rigibo.frontend.puzzle.session;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

import java.util.IdentityHashMap;
import java.util.Map;

/** The poses of the bodies before the last step, from which slow motion interpolates. */
final class Poses {

    private final Map<RigidBody, Pose> before = new IdentityHashMap<>();

    /** Called before each step. */
    void remember(Pool pool) {
        before.clear();
        for (RigidBody body : pool.bodies()) {
            before.put(body, Pose.of(body));
        }
    }

    /** Forgets all poses, for another game. */
    void forget() {
        before.clear();
    }

    /**
     * The pose at which a body is drawn.
     *
     * @param share of the time from the beginning of the last step to its end, 0 to 1
     */
    Pose of(RigidBody body, double share) {
        Pose now = Pose.of(body);
        return before.getOrDefault(body, now).towards(now, share);
    }

    /** The pose of a body that the last step deleted. */
    Pose last(RigidBody deleted) {
        return before.get(deleted);
    }
}
