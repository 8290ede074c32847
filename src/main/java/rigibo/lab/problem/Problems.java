package rigibo.lab.problem;

import java.util.List;
import java.util.NoSuchElementException;

/** All reference problems, in the order of their numbers. */
public final class Problems {

    private static final List<Problem> ALL =
            List.of(
                    BallisticFlight.problem(),
                    Drags.problem(),
                    Spring.problem(),
                    Orbit.problem(),
                    ElasticBalls.problem(),
                    Rebounds.problem(),
                    PulledBox.problem(),
                    SlideAndRoll.problem(),
                    Stacks.problem(),
                    Billiards.problem(),
                    DiscHeap.problem(),
                    HeavyOnLight.problem(),
                    Demos.problem(),
                    CrowdProblem.rain(400),
                    CrowdProblem.settling(30),
                    CrowdProblem.struck(40),
                    Assembled.pendulum(),
                    Assembled.chain(),
                    Assembled.springs(),
                    CrowdProblem.ragdolls(20));

    private Problems() {}

    public static List<Problem> all() {
        return ALL;
    }

    /**
     * The problem of an id.
     *
     * @throws NoSuchElementException naming it where there is none
     */
    public static Problem numbered(String id) {
        return ALL.stream()
                .filter(problem -> problem.id().equals(id))
                .findFirst()
                .orElseThrow(() -> new NoSuchElementException("no problem '" + id + "'"));
    }
}
