package rigibo.lab.bench.moving;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.lab.bench.probe.StepTimes;

class CourseTest {

    private static final Course COURSE =
            new Course(
                    new double[] {100, 400, 200, 300},
                    new double[] {0, 10, 4, 6},
                    2,
                    0.25,
                    0.125,
                    Double.NaN,
                    0,
                    1e-3);

    @Test
    void timesAreOfTheFirstStepsOnly() {
        StepTimes times = COURSE.times(3);
        assertThat(times.mean()).isEqualTo(700 / 3.0);
        assertThat(times.max()).isEqualTo(400);
        assertThat(times.median()).isEqualTo(200);
        assertThat(COURSE.times(99).p99()).isEqualTo(400);
    }

    /** Of 0, 10, 4 and 6 contacts two are at least half of ten, in steps of 400 and 300 ns. */
    @Test
    void busyStepsHaveHalfOfTheMostContacts() {
        assertThat(COURSE.busyTimes(4).mean()).isEqualTo(350);
    }
}
