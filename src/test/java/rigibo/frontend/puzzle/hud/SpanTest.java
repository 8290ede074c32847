package rigibo.frontend.puzzle.hud;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.List;

class SpanTest {

    private static final Span PLAY = new Span(56, 768);
    private static final double HEIGHT = 250;

    private static double top(Span... kept) {
        return PLAY.clearTop(HEIGHT, List.of(kept));
    }

    @Test
    void isAtTheTopWhereNothingIsInTheWay() {
        assertThat(top()).isEqualTo(68);
        assertThat(top(new Span(400, 424))).isEqualTo(68);
    }

    /**
     * With the ball in the upper half and the platform at the lower edge, it lies between the two.
     */
    @Test
    void liesBetweenWhatIsAboveAndBelow() {
        assertThat(top(new Span(200, 256), new Span(700, 724))).isEqualTo(268);
    }

    @Test
    void liesBelowBallAndPlatformTogether() {
        assertThat(top(new Span(200, 256), new Span(256, 280))).isEqualTo(292);
    }

    /** It covers 24 px of the platform instead of 56 px of a ball. */
    @Test
    void coversAsLittleAsCanBe() {
        assertThat(top(new Span(200, 256), new Span(450, 474), new Span(600, 656)))
                .isEqualTo(68 + 200);
    }
}
