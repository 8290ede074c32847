package rigibo.frontend.scene;

import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

import java.util.function.Consumer;

/** What a hand reaches: a pool, and whoever has to be told what is done to it. */
public interface Bench {

    /** What the bodies are in. */
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
