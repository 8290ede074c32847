package rigibo.frontend.scene.trial;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;

class TrialsTest {

    private final Queue<Runnable> asked = new ArrayDeque<>();
    private final Trials trials = Trials.on(asked::add, () -> 0);

    /** A trial whose outcome is the number of its pieces. */
    private static Trial<Integer> of(int pieces) {
        int[] done = {0};
        return () -> {
            done[0]++;
            return done[0] == pieces ? Optional.of(done[0]) : Optional.empty();
        };
    }

    @Test
    void isDoneAfterTheLastPiece() {
        CompletableFuture<Integer> outcome = trials.start(of(3));
        assertThat(outcome).isNotDone();
        asked.remove().run();
        assertThat(outcome).isCompletedWithValue(3);
    }

    @Test
    void handsOverWhatWentWrong() {
        CompletableFuture<Integer> outcome =
                trials.start(
                        () -> {
                            throw new IllegalStateException("broken");
                        });
        asked.remove().run();
        assertThat(outcome).isCompletedExceptionally();
    }
}
