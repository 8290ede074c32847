package rigibo.backend.law;

import java.util.Optional;

/** Something that is true in every scene. */
@FunctionalInterface
interface Law {

    /** What is broken in a scene, with its figures; empty where the law holds. */
    Optional<String> broken(RandomScene scene);

    /** The same words where a figure is beyond its limit; a figure that is not a number is. */
    static Optional<String> atMost(double limit, double figure, String words) {
        return figure <= limit
                ? Optional.empty()
                : Optional.of(words + " " + figure + ", at most " + limit);
    }
}
