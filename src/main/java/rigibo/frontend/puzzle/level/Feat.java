package rigibo.frontend.puzzle.level;

/** The condition, besides solving the level, that earns the level's star. */
public sealed interface Feat {

    /**
     * The level is solved with an exact number of clicks.
     *
     * @param count par or more
     */
    record Clicks(int count) implements Feat {}

    /**
     * The level is solved within a time, the hold included.
     *
     * @param seconds s since the start
     */
    record Quick(double seconds) implements Feat {}

    /**
     * No ball ever touches a body.
     *
     * @param body its id
     */
    record AvoidBody(String body) implements Feat {}

    /** No ball ever touches a body of a material; the platform has none. */
    record AvoidMaterial(Substance material) implements Feat {}

    /**
     * A ball touches a body, however briefly.
     *
     * @param body its id
     */
    record Touch(String body) implements Feat {}

    /**
     * A body is still in the world at the end.
     *
     * @param body its id
     */
    record Keep(String body) implements Feat {}

    /** No body that a click could delete is left at the end. */
    record Clear() implements Feat {}

    /** No body has fallen out of the world by the end. */
    record Inside() implements Feat {}

    /**
     * The first click acts on a certain target.
     *
     * @param target id of a body or joint
     */
    record First(String target) implements Feat {}
}
