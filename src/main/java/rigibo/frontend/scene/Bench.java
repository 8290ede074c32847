package rigibo.frontend.scene;

import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

import java.util.function.Consumer;

/**
 * The bodies that a hand can reach: a pool, and verbs for every change of its bodies and joints, so
 * that a ghost can follow.
 */
public interface Bench {

    /** The pool that holds the bodies. */
    Pool pool();

    /** Joins two bodies. */
    default Joint join(JointDefinition definition) {
        return pool().join(definition);
    }

    /** Ends a joint. */
    default void part(Joint joint) {
        pool().remove(joint);
    }

    /** Does something to a body. */
    default void act(RigidBody body, Consumer<RigidBody> verb) {
        verb.accept(body);
    }

    /** Does something to a joint. */
    default void act(Joint joint, Consumer<Joint> verb) {
        verb.accept(joint);
    }
}
