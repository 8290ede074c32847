package rigibo.fuzz.chance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/** Ours draws what the JVM's does. */
class DrawsTest {

    @ParameterizedTest
    @ValueSource(longs = {0, 1, -1, 25, Long.MIN_VALUE, 0x9E3779B97F4A7C15L})
    void drawsWhatTheJvmDraws(long seed) {
        Draws ours = new Draws(seed);
        Random jvm = new Random(seed);
        for (int i = 1; i < 2_000; i++) {
            assertThat(ours.nextDouble()).isEqualTo(jvm.nextDouble());
            assertThat(ours.nextBoolean()).isEqualTo(jvm.nextBoolean());
            assertThat(ours.nextLong()).isEqualTo(jvm.nextLong());
            assertThat(ours.nextInt(i)).isEqualTo(jvm.nextInt(i));
            assertThat(ours.nextInt(Integer.MAX_VALUE - i))
                    .isEqualTo(jvm.nextInt(Integer.MAX_VALUE - i));
        }
    }
}
