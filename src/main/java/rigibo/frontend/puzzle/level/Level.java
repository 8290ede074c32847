package rigibo.frontend.puzzle.level;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.stream.Stream;

/**
 * A level as its file states it.
 *
 * @param id unique among the levels
 * @param title shown in menus
 * @param hint shown on request; empty if there is none
 * @param world its space and effects
 * @param limits the numbers of its rules
 * @param balls all of which must reach the platform; at least one
 * @param platform on which they must stay
 * @param bodies all others, in the file's order
 * @param joints between them, in the file's order
 * @param solutions clicks known to win
 * @param star the secret one, if there is one
 * @param origin seed and generator, if it was made by chance
 */
public record Level(
        String id,
        Wording title,
        Wording hint,
        World world,
        Limits limits,
        List<Ball> balls,
        Platform platform,
        List<LevelBody> bodies,
        List<LevelJoint> joints,
        List<Solution> solutions,
        Optional<Star> star,
        Optional<Origin> origin) {

    public Level {
        balls = List.copyOf(balls);
        bodies = List.copyOf(bodies);
        joints = List.copyOf(joints);
        solutions = List.copyOf(solutions);
    }

    /** Returns this level with another id and title, which do not affect its hash. */
    public Level called(String otherId, Wording otherTitle) {
        return with(otherId, otherTitle, origin);
    }

    /** Returns this level with an origin, which does not affect its hash. */
    public Level madeFrom(Origin seed) {
        return with(id, title, Optional.of(seed));
    }

    private Level with(String otherId, Wording otherTitle, Optional<Origin> otherOrigin) {
        return new Level(
                otherId,
                otherTitle,
                hint,
                world,
                limits,
                balls,
                platform,
                bodies,
                joints,
                solutions,
                star,
                otherOrigin);
    }

    /** A 64-bit hash of all that play depends on; texts, solutions and star do not affect it. */
    public long hash() {
        return LevelHash.of(this);
    }

    /** All targets of clicks: bodies in the file's order, then joints. */
    public List<Clickable> clickables() {
        return clickables(bodies, joints);
    }

    static List<Clickable> clickables(List<LevelBody> bodies, List<LevelJoint> joints) {
        Stream<Clickable> ofBodies =
                bodies.stream()
                        .flatMap(
                                body ->
                                        body.verb().stream()
                                                .map(verb -> new Clickable(body.id(), verb)));
        Stream<Clickable> ofJoints =
                joints.stream()
                        .flatMap(
                                joint ->
                                        joint.verb().stream()
                                                .map(
                                                        verb ->
                                                                new Clickable(
                                                                        joint.id().orElseThrow(),
                                                                        verb)));
        return Stream.concat(ofBodies, ofJoints).toList();
    }

    /** The action of a click on a body or joint by its id; empty if it is not clickable. */
    public Optional<Verb> verb(String target) {
        return clickables().stream()
                .filter(it -> it.id().equals(target))
                .findFirst()
                .map(Clickable::verb);
    }

    /** Whether an id is that of a joint. */
    public boolean isJoint(String target) {
        return joints.stream().anyMatch(joint -> joint.id().filter(target::equals).isPresent());
    }

    /**
     * Returns this level with all movable bodies slightly displaced, to tell skill from luck.
     *
     * @param metres draws the displacement of the next body to the right, m
     */
    public Level shiftedSideways(DoubleSupplier metres) {
        List<LevelBody> shifted =
                bodies.stream()
                        .map(body -> body.isDynamic() ? body.shifted(metres.getAsDouble()) : body)
                        .toList();
        return new Level(
                id,
                title,
                hint,
                world,
                limits,
                balls.stream().map(ball -> ball.shifted(metres.getAsDouble())).toList(),
                platform,
                shifted,
                joints,
                solutions,
                star,
                origin);
    }
}
