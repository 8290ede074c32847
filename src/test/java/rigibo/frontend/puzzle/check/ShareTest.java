package rigibo.frontend.puzzle.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ShareTest {

    private static final double ROUNDED = 5e-4;

    /** Both ends solve (p - s)² = z² p (1 - p) / n, here with s = 0.1, n = 300, z = 1.96. */
    @Test
    void aSampleTellsHowFarOffItMayBe() {
        Share share = new Share(30, 300, false);
        assertThat(share.least()).isCloseTo(0.0709, within(ROUNDED));
        assertThat(share.most()).isCloseTo(0.1391, within(ROUNDED));
        assertThat(share).hasToString("10 %, with 95 % certainty 7.1 to 13.9 %");
    }

    /** Without a win the upper end is z² / (n + z²). */
    @Test
    void noWinInASampleIsNoProof() {
        Share share = new Share(0, 300, false);
        assertThat(share.least()).isCloseTo(0, within(1e-12));
        assertThat(share.most()).isCloseTo(3.8416 / 303.8416, within(1e-12));
    }

    @Test
    void allGamesLeaveNoDoubt() {
        Share share = new Share(1, 4, true);
        assertThat(share.least()).isEqualTo(0.25);
        assertThat(share.most()).isEqualTo(0.25);
        assertThat(share).hasToString("25 %");
    }
}
