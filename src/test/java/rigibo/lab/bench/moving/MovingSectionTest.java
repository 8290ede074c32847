package rigibo.lab.bench.moving;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

class MovingSectionTest {

    private static final Contestant PEER = new Contestant("gdx-box2d 1.14.0", "as it comes");

    /** Steps of 10 µs, one of them longer, the last one in which anything moves given. */
    private static Course course(double worst, int lastMoving) {
        double[] nanos = new double[200];
        Arrays.fill(nanos, 10_000);
        nanos[50] = worst;
        double[] contacts = new double[200];
        Arrays.fill(contacts, 5);
        return new Course(nanos, contacts, lastMoving, 0.1, 0, 0, 0, 0);
    }

    private static MovingSection section(Course ours, Course theirs) {
        Map<Contestant, Course> courses = new LinkedHashMap<>();
        courses.put(Contestant.OURS, ours);
        courses.put(PEER, theirs);
        return new MovingSection("rain", courses, 200);
    }

    /** The step that moves last is step 120 of one and 90 of the other, counted from 0. */
    @Test
    void stepsCountUntilNeitherMoves() {
        assertThat(section(course(10_000, 120), course(10_000, 90)).passage().title())
                .isEqualTo("rain, 121 steps");
    }

    @Test
    void engineThatIsTwiceAsSlowMeetsTheAimAndAnEqualOneDoesNot() {
        Course slow = course(20_000, 100);
        Arrays.fill(slow.nanos(), 20_000);
        assertThat(section(course(10_000, 100), slow).sentences().get(0))
                .contains("2.00 × ours (≥ 2: met)", "p99 is 0.50 × (≤ 0.50: met)");
        assertThat(section(course(10_000, 100), course(10_000, 100)).sentences().get(0))
                .contains("1.00 × ours (≥ 2: not met)", "p99 is 1.00 × (≤ 0.50: not met)");
    }

    @Test
    void longestStepIsHeldToTheLongestOfTheOther() {
        assertThat(section(course(90_000, 100), course(30_000, 100)).sentences().get(0))
                .contains("our max 3.00 × (≤ 1.00: not met)");
    }

    @Test
    void whatNeverRestsIsTold() {
        assertThat(section(course(1, 199), course(1, 99)).table().rows())
                .extracting(row -> row.get(row.size() - 1))
                .containsExactly("not yet", "1.7 s");
    }
}
