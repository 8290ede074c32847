package rigibo.backend.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;

@Timeout(60)
class ThreadTeamTest {

    private static final int PIECES = 2_000;

    /**
     * Threads that come in time take the remaining pieces, and none is still working when the call
     * returns.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 8})
    void allWorkIsDoneOnce(int workers) {
        int[] done = new int[200];
        int[] expected = new int[200];
        Set<Thread> by = ConcurrentHashMap.newKeySet();
        try (Team team = new ThreadTeam(workers)) {
            assertThat(team.size()).isEqualTo(workers);
            for (int piece = 1; piece <= PIECES; piece++) {
                int count = piece % (done.length + 1);
                team.split(
                        count,
                        1 + piece % 7,
                        (from, to, worker) -> {
                            by.add(Thread.currentThread());
                            for (int i = from; i < to; i++) {
                                done[i]++;
                            }
                        });
                Arrays.setAll(expected, i -> expected[i] + (i < count ? 1 : 0));
                assertThat(done).isEqualTo(expected);
            }
        }
        assertThat(by).contains(Thread.currentThread()).hasSizeLessThanOrEqualTo(workers);
        assertThat(by).allMatch(one -> one == Thread.currentThread() || one.isDaemon());
    }

    /** A caller that waits for the others finds them, however long they take to wake up. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void workersHaveNumbersOfTheirOwn(int workers) {
        Thread[] by = new Thread[workers];
        try (Team team = new ThreadTeam(workers)) {
            team.split(by.length, 1, waiting(by));
        }
        assertThat(by).doesNotHaveDuplicates().doesNotContainNull();
        assertThat(by[0]).isSameAs(Thread.currentThread());
    }

    /** Work at which the caller waits until every worker has begun. */
    private static Team.Pieces waiting(Thread[] by) {
        CountDownLatch begun = new CountDownLatch(by.length);
        return (from, to, worker) -> {
            by[worker] = Thread.currentThread();
            begun.countDown();
            try {
                begun.await();
            } catch (InterruptedException interrupted) {
                throw new AssertionError(interrupted);
            }
        };
    }

    /** Each worker finds its share where it was, so that its cache holds what it works on. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void everyWorkerBeginsWithItsOwnShare(int workers) {
        int[] starts = new int[workers];
        try (Team team = new ThreadTeam(workers)) {
            for (int i = 0; i < 20; i++) {
                Team.Pieces all = waiting(new Thread[workers]);
                team.split(
                        5 * workers,
                        5,
                        (from, to, worker) -> {
                            starts[worker] = from;
                            all.run(from, to, worker);
                        });
                for (int worker = 0; worker < workers; worker++) {
                    assertThat(starts[worker]).isEqualTo(5 * worker);
                }
            }
        }
    }

    @Test
    void splitsAreCounted() {
        try (Team team = new ThreadTeam(2)) {
            for (int i = 0; i < 7; i++) {
                team.split(i, 1, (from, to, worker) -> {});
            }
            assertThat(team.takeSplits()).isEqualTo(7);
            assertThat(team.takeSplits()).isZero();
        }
    }

    @Test
    void failuresReachTheCallerAndTheTeamGoesOn() {
        try (Team team = new ThreadTeam(3)) {
            for (int failing = 0; failing < 3; failing++) {
                int who = failing;
                Team.Pieces all = waiting(new Thread[3]);
                assertThatIllegalStateException()
                        .isThrownBy(
                                () ->
                                        team.split(
                                                3,
                                                1,
                                                (from, to, worker) -> {
                                                    all.run(from, to, worker);
                                                    if (worker == who) {
                                                        throw new ArithmeticException("by one");
                                                    }
                                                }))
                        .withRootCauseInstanceOf(ArithmeticException.class);
                Thread[] by = new Thread[3];
                team.split(by.length, 1, waiting(by));
                assertThat(by).doesNotContainNull();
            }
        }
    }

    @Test
    void threadsEndWithTheTeam() throws InterruptedException {
        Thread[] by = new Thread[2];
        try (Team team = new ThreadTeam(2)) {
            team.split(by.length, 1, waiting(by));
            assertThat(by[1].isAlive()).isTrue();
        }
        by[1].join();
    }

    /** Its thread holds on to the team, not to what the team works for. */
    @Test
    void threadsEndWhenTheirOwnerIsForgotten() throws InterruptedException {
        Thread[] by = new Thread[2];
        Object owner = new Object();
        ThreadTeam team = new ThreadTeam(2);
        team.closeWith(owner);
        team.split(by.length, 1, waiting(by));
        assertThat(by[1].isAlive()).isTrue();
        owner = null;
        while (by[1].isAlive()) {
            System.gc();
            by[1].join(10);
        }
    }

    /** Threads that wait for work give their core away after a moment. */
    @Test
    void whoHasNothingToDoIsParked() throws InterruptedException {
        Thread[] by = new Thread[2];
        try (Team team = new ThreadTeam(2)) {
            team.split(by.length, 1, waiting(by));
            while (by[1].getState() != Thread.State.WAITING) {
                Thread.sleep(1);
            }
            Thread[] again = new Thread[2];
            team.split(again.length, 1, waiting(again));
            assertThat(again).isEqualTo(by);
        }
    }
}
