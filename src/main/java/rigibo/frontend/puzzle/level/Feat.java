package rigibo.frontend.puzzle.level;

/** What a game that solves its level has to show to earn the level's star. */
public sealed interface Feat {

    /**
     * The level is solved with exactly so many clicks.
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

    /** No ball ever touches anything of a material; the platform is of none. */
    record AvoidMaterial(Substance material) implements Feat {}

    /**
     * A ball touches a body, however shortly.
     *
     * @param body its id
     */
    record Touch(String body) implements Feat {}

    /**
     * A body is still in the world in the end.
     *
     * @param body its id
     */
    record Keep(String body) implements Feat {}

    /** Nothing is left in the end that a click could delete. */
    record Clear() implements Feat {}

    /** Nothing has fallen out of the world by the end. */
    record Inside() implements Feat {}

    /**
     * The first click acts on a certain target.
     *
     * @param target id of a body or joint
     */
    record First(String target) implements Feat {}
}
