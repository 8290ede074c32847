package rigibo.backend.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;

class RehearsedTeamTest {

    /** ns; pieces of work let it go on. */
    private long now = 1_000;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 8})
    void allWorkIsDoneOnce(int workers) {
        Team team = new RehearsedTeam(workers, () -> now);
        assertThat(team.size()).isEqualTo(workers);
        for (int count = 0; count <= 60; count++) {
            int[] done = new int[count];
            team.split(count, 1 + count % 7, (from, to, worker) -> add(done, from, to));
            assertThat(done).containsOnly(Arrays.stream(done).map(times -> 1).toArray());
        }
        assertThat(team.takeSplits()).isEqualTo(61);
        assertThat(team.takeSplits()).isZero();
    }

    private void add(int[] done, int from, int to) {
        for (int i = from; i < to; i++) {
            done[i]++;
            now += 10 + i;
        }
    }

    /**
     * Pieces of the same length: n of them keep w workers busy for ⌈n / w⌉ of them, whatever their
     * shares are.
     */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, 4", "7, 1", "7, 2", "8, 2", "8, 3", "9, 4", "64, 8", "65, 8"})
    void likePiecesTakeTheLeastTime(int pieces, int workers) {
        Team team = new RehearsedTeam(workers, () -> now);
        team.split(pieces, 1, (from, to, worker) -> now += 100);
        int longest = (pieces + workers - 1) / workers;
        assertThat(team.takeSpared()).isEqualTo(100L * (pieces - longest));
        assertThat(team.takeSpared()).isZero();
    }

    /** While the first worker is at a piece of 10, the second does all of the rest, 1 each. */
    @Test
    void whoIsDoneTakesWhatOthersHaveNotBegun() {
        Team team = new RehearsedTeam(2, () -> now);
        int[] by = new int[8];
        team.split(
                8,
                1,
                (from, to, worker) -> {
                    by[from] = worker;
                    now += from == 0 ? 10 : 1;
                });
        assertThat(by).containsExactly(0, 1, 1, 1, 1, 1, 1, 1);
        assertThat(team.takeSpared()).isEqualTo(7);
    }

    /** Work that one worker does alone between two splits saves no time. */
    @Test
    void onlySharedWorkIsSpared() {
        Team team = new RehearsedTeam(4, () -> now);
        now += 1_000;
        team.split(4, 1, (from, to, worker) -> now += 7);
        now += 1_000;
        team.split(4, 1, (from, to, worker) -> now += 5);
        assertThat(team.takeSpared()).isEqualTo(3 * 7 + 3 * 5);
    }

    @Test
    void aPieceThatThrowsIsToldAfterAllOthers() {
        Team team = new RehearsedTeam(2, () -> now);
        IllegalArgumentException thrown = new IllegalArgumentException("broken");
        int[] done = new int[4];
        assertThatIllegalStateException()
                .isThrownBy(
                        () ->
                                team.split(
                                        4,
                                        1,
                                        (from, to, worker) -> {
                                            done[from]++;
                                            if (from == 1) {
                                                throw thrown;
                                            }
                                        }))
                .withCause(thrown);
        assertThat(done).containsOnly(1);
    }
}
