package rigibo.backend.storage;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;

/** An impulse that is told pushes, and is a number. */
class ToldImpulsesTest {

    private final Pairs pairs = new Pairs(Effects.usual());

    @Test
    void whatPushesAddsUp() {
        pairs.tellImpulse(0, 2);
        pairs.tellImpulse(0, 3);
        assertThat(pairs.impulse[0]).isEqualTo(5);
    }

    /** A whole solve may leave 10⁻¹⁶ of the greatest load as pull where nothing is loaded. */
    @ParameterizedTest
    @ValueSource(doubles = {-1e-130, Double.NaN, Double.POSITIVE_INFINITY})
    void traceOfPullAndWhatIsBeyondAllBoundsAreNot(double impulse) {
        pairs.tellImpulse(0, 2);
        pairs.tellImpulse(0, impulse);
        assertThat(pairs.impulse[0]).isEqualTo(2);
    }
}
