package rigibo.backend.saved;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.PoolSnapshot;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.Arrays;

/** A snapshot says which revision of the simulation wrote it, and goes on in that one only. */
class RevisionTest {

    private static final int HEADER_BYTES = 24;

    /** After the label, a byte for its length and eight letters: the last byte of the number. */
    private static final int REVISION_AT = HEADER_BYTES + 9 + 3;

    private static final int OTHER = Pool.REVISION + 6;

    private final Pool pool = falling();
    private final byte[] present = pool.snapshot();
    private final byte[] other = ofOtherRevision(present);

    private static Pool falling() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 5));
        pool.step(1.0 / 60);
        return pool;
    }

    private static byte[] ofOtherRevision(byte[] snapshot) {
        byte[] altered = snapshot.clone();
        assertThat(altered[REVISION_AT]).isEqualTo((byte) Pool.REVISION);
        altered[REVISION_AT] = OTHER;
        return Envelope.seal(Arrays.copyOfRange(altered, HEADER_BYTES, altered.length));
    }

    @Test
    void aSnapshotSaysItsRevision() {
        assertThat(PoolSnapshot.revision(present)).isEqualTo(Pool.REVISION);
        assertThat(PoolSnapshot.revision(other)).isEqualTo(OTHER);
    }

    @Test
    void anotherRevisionIsRefusedInWords() {
        String words =
                "Pool.restore snapshot: must be of revision "
                        + Pool.REVISION
                        + " of the simulation, was "
                        + OTHER;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(other))
                .withMessageStartingWith(words)
                .withMessageContaining("PoolSnapshot.restoreOfAnyRevision");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(other, Effects.usual()))
                .withMessageStartingWith(words);
    }

    @Test
    void whoAsksForItGoesOnFromTheSameState() {
        Pool goingOn = PoolSnapshot.restoreOfAnyRevision(other);
        assertThat(goingOn.stateHash()).isEqualTo(pool.stateHash());
        assertThat(PoolSnapshot.revision(goingOn.snapshot())).isEqualTo(Pool.REVISION);
        Effects moon = Effects.usual().with(new Gravity(0, -1.62));
        assertThat(PoolSnapshot.restoreOfAnyRevision(other, moon).effects()).isSameAs(moon);
    }

    @Test
    void whatIsAlteredIsRefusedWhateverIsAskedOfIt() {
        byte[] altered = present.clone();
        altered[REVISION_AT]++;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PoolSnapshot.revision(altered))
                .withMessageStartingWith("PoolSnapshot.revision snapshot: must be unaltered");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PoolSnapshot.restoreOfAnyRevision(altered))
                .withMessageStartingWith(
                        "PoolSnapshot.restoreOfAnyRevision snapshot: must be unal");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PoolSnapshot.restoreOfAnyRevision(null))
                .withMessageContaining("snapshot must be given");
    }
}
