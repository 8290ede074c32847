package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Monkey;

/** The game survives random input in real windows. {@code ./rigibo monkey} runs for longer. */
class MonkeyTest {

    private static final int TWENTY_SECONDS = 1200;
    private static final long SEED = 7;

    /** Exceptions would end it; the seed does the same again. */
    @Test
    void bearsRandomInput() {
        Monkey.Report report = Monkey.play(Catalog::menu, Catalog.entries(), TWENTY_SECONDS, SEED);
        assertThat(report.troubles()).isEmpty();
        assertThat(report.turns()).isEqualTo(TWENTY_SECONDS);
        assertThat(report.windows()).isGreaterThan(5);
    }
}
