package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Monkey;

/** The game survives random input in real windows. {@code ./rigibo monkey} runs for longer. */
class MonkeyTest {

    private static final int HALF_A_MINUTE = 1800;
    private static final long SEED = 7;

    /** Exceptions would end it; the seed does the same again. */
    @Test
    void bearsRandomInput() {
        Monkey.Report report = Monkey.play(Catalog::menu, Catalog.entries(), HALF_A_MINUTE, SEED);
        assertThat(report.troubles()).isEmpty();
        assertThat(report.turns()).isEqualTo(HALF_A_MINUTE);
        assertThat(report.windows()).isGreaterThan(5);
    }
}
