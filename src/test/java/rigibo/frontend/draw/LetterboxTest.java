package rigibo.frontend.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class LetterboxTest {

    @Test
    void fillsAFramebufferOfItsOwnProportions() {
        assertThat(Letterbox.of(1440, 1600)).isEqualTo(new Letterbox(0, 0, 1440, 1600));
    }

    @Test
    void leavesBarsAtTheSidesOfAWideScreen() {
        // 1080 high leaves 1080 · 720/800 = 972 for the width, and (1920 − 972)/2 = 474 beside it.
        assertThat(Letterbox.of(1920, 1080)).isEqualTo(new Letterbox(474, 0, 972, 1080));
    }

    @Test
    void bringsThePointerToLogicalPixels() {
        Letterbox box = Letterbox.of(1920, 1080);
        assertThat(box.logicalX(474)).isZero();
        assertThat(box.logicalX(474 + 972)).isEqualTo(720);
        assertThat(box.logicalY(540, 1080)).isCloseTo(400, within(1e-9));
    }

    @Test
    void findsALogicalPlaceOnTheFramebuffer() {
        // The reverse of the above, in a framebuffer that is too high: 400 at the top and below.
        Letterbox box = Letterbox.of(720, 1600);
        assertThat(box.framebufferX(90)).isEqualTo(90);
        assertThat(box.framebufferY(0, 1600)).isEqualTo(400);
        assertThat(box.logicalY(box.framebufferY(123, 1600), 1600)).isCloseTo(123, within(1e-9));
    }

    @Test
    void survivesAWindowOfNoSize() {
        assertThat(Letterbox.of(0, 0).width()).isPositive();
    }
}
