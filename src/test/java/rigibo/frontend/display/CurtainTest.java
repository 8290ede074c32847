package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CurtainTest {

    private final Curtain curtain = new Curtain();

    @Test
    void nothingIsDarkWhereItNeverFell() {
        assertThat(curtain.rise()).isZero();
    }

    @Test
    void risesFromBlackToClearWithoutStepsBack() {
        curtain.drop();
        double before = curtain.rise();
        assertThat(before).isOne();
        for (int frame = 0; frame < Curtain.FRAMES; frame++) {
            double now = curtain.rise();
            assertThat(now).isLessThan(before);
            before = now;
        }
        assertThat(before).isZero();
    }

    @Test
    void fallsToBlack() {
        assertThat(Curtain.fallen(1)).isBetween(0.0, 0.5);
        assertThat(Curtain.fallen(Curtain.FRAMES)).isOne();
    }
}
