package rigibo.backend.law;

import java.util.Optional;

/** Something that is true in every scene. */
@FunctionalInterface
interface Law {

    /**
     * What is broken in a scene, with its figures; empty where the law holds.
     *
     * @param asked takes note of every occasion that the scene gave to break the law
     */
    Optional<String> broken(RandomScene scene, Asked asked);
}
