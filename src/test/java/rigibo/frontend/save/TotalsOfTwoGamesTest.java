package rigibo.frontend.save;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.Totals;

/** Two games that count at once: each adds what it has counted itself, and nothing twice. */
class TotalsOfTwoGamesTest {

    private final ProgressFormat format = new ProgressFormat();

    @Test
    void whatBothCountIsAdded() {
        Progress before = Progress.none().played(new Totals(10, 20, 30));
        Progress other = before.played(new Totals(1, 1, 100));
        Progress own = before.played(new Totals(2, 5, 70));
        assertThat(format.merged(before, other, own).totals()).isEqualTo(new Totals(13, 26, 200));
        assertThat(format.merged(own, other, own).totals())
                .as("nothing new here")
                .isEqualTo(other.totals());
    }
}
