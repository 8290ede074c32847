package rigibo.frontend.puzzle.show;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ClipTest {

    private final Clip clip = new Clip();

    ClipTest() {
        clip.to(10, 20, 110, 220);
    }

    private double[] rest() {
        return new double[] {clip.fromX, clip.fromY, clip.toX, clip.toY};
    }

    @Test
    void aLineInsideStaysWhole() {
        assertThat(clip.cut(20, 30, 100, 200)).isTrue();
        assertThat(rest()).containsExactly(20, 30, 100, 200);
    }

    @Test
    void aLineAcrossIsCutAtBothEdges() {
        assertThat(clip.cut(-90, 120, 210, 120)).isTrue();
        assertThat(rest()).containsExactly(10, 120, 110, 120);
        assertThat(clip.cut(60, 320, 60, -80)).isTrue();
        assertThat(rest()).containsExactly(60, 220, 60, 20);
    }

    @Test
    void nothingIsLeftOfALineOutside() {
        assertThat(clip.cut(0, 0, 0, 300)).isFalse();
        assertThat(clip.cut(200, 0, 300, 300)).isFalse();
        assertThat(clip.cut(0, 25, 25, 0)).as("past a corner").isFalse();
    }
}
