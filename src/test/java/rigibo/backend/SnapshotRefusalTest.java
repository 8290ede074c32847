package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.assertj.core.api.ThrowableAssertAlternative;
import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Thrust;
import rigibo.backend.setup.Accuracy;

import java.util.Arrays;
import java.util.Random;

/** Bytes that are no snapshot are refused, always with the one exception and a sentence. */
class SnapshotRefusalTest {

    private static final byte[] SNAPSHOT = snapshot();

    private static final int VERSION_AT = 11;

    private static byte[] snapshot() {
        Pool pool = Potpourri.build(Accuracy.GAME);
        Potpourri.run(pool, 0, 30);
        return pool.snapshot();
    }

    @Test
    void everyCutIsRefused() {
        for (int length = 0; length < SNAPSHOT.length; length++) {
            requireRefusal(Arrays.copyOf(SNAPSHOT, length), "cut to " + length);
        }
        requireRefusal(Arrays.copyOf(SNAPSHOT, SNAPSHOT.length + 1), "one byte more");
        requireRefusal(Arrays.copyOf(SNAPSHOT, SNAPSHOT.length + 8), "a word more");
    }

    @Test
    void everyAlteredByteIsRefused() {
        long seed = 7;
        Random random = new Random(seed);
        for (int at = 0; at < SNAPSHOT.length; at++) {
            byte[] altered = SNAPSHOT.clone();
            altered[at] ^= (byte) (1 + random.nextInt(255));
            requireRefusal(altered, "altered at " + at + ", seed " + seed);
        }
    }

    @Test
    void everySingleBitOfTheHeaderCounts() {
        for (int bit = 0; bit < 8 * 24; bit++) {
            byte[] altered = SNAPSHOT.clone();
            altered[bit / 8] ^= (byte) (1 << bit % 8);
            requireRefusal(altered, "bit " + bit);
        }
    }

    @Test
    void emptyAndStrangeBytesAreRefused() {
        assertRefused(new byte[0]).withMessageContaining("24 bytes or more, was 0");
        assertRefused(new byte[1000]).withMessageContaining("RigiBo wrote");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(null))
                .withMessageContaining("Pool.restore snapshot must be given");
    }

    @Test
    void newerFormatIsRefused() {
        byte[] newer = SNAPSHOT.clone();
        newer[VERSION_AT]++;
        assertRefused(newer)
                .withMessageContaining("format up to 11, was 12")
                .withMessageContaining("a newer version wrote it");
    }

    @Test
    void cutAndAlteredAreToldApart() {
        assertRefused(Arrays.copyOf(SNAPSHOT, SNAPSHOT.length / 2))
                .withMessageContaining("be whole")
                .withMessageContaining(SNAPSHOT.length + ", was " + SNAPSHOT.length / 2);
        byte[] altered = SNAPSHOT.clone();
        altered[SNAPSHOT.length / 2]++;
        assertRefused(altered).withMessageContaining("be unaltered");
    }

    @Test
    void effectsOfOtherKindsAreRefused() {
        Effects more = Potpourri.EFFECTS.without(Thrust.class).without(Drag.class);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(SNAPSHOT, more))
                .withMessageContaining("lacks [Drag, Thrust] and does not declare []");
        byte[] usual = new Pool().snapshot();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(usual, Potpourri.EFFECTS))
                .withMessageContaining(
                        "lacks [] and does not declare [Drag, RollingResistance, Thrust]");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(usual, null))
                .withMessageContaining("Pool.restore effects must be given");
    }

    private static void requireRefusal(byte[] bytes, String what) {
        assertThatExceptionOfType(IllegalArgumentException.class)
                .as(what)
                .isThrownBy(() -> Pool.restore(bytes))
                .withMessageStartingWith("Pool.restore snapshot: must ");
    }

    private static ThrowableAssertAlternative<IllegalArgumentException> assertRefused(
            byte[] bytes) {
        assertThat(bytes).isNotEqualTo(SNAPSHOT);
        return assertThatIllegalArgumentException().isThrownBy(() -> Pool.restore(bytes));
    }
}
