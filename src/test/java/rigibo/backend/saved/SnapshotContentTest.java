package rigibo.backend.saved;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import static java.nio.charset.StandardCharsets.US_ASCII;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;
import java.util.Random;
import java.util.function.Consumer;

/** A snapshot with the right checksum over what no pool can be in. */
class SnapshotContentTest {

    private static final double DT = 1.0 / 60;
    private static final int HEADER_BYTES = 24;

    private static Pool heap() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        for (int i = 0; i < 6; i++) {
            pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0.1 * i, 0.5 + i));
            pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(3, 0.4 + i).name("disc " + i));
        }
        pool.remove(pool.bodies().get(4));
        for (int i = 0; i < 20; i++) {
            pool.step(DT);
        }
        return pool;
    }

    /** A snapshot of any bytes is refused with a message, or restored to a pool that can step. */
    @Test
    void anyContentIsRefusedOrGoesOn() {
        byte[] snapshot = heap().snapshot();
        byte[] content = Arrays.copyOfRange(snapshot, HEADER_BYTES, snapshot.length);
        int taken = 0;
        for (int seed = 0; seed < 3000; seed++) {
            Random random = new Random(seed);
            byte[] altered = content.clone();
            for (int i = 0; i <= seed % 3; i++) {
                altered[random.nextInt(altered.length)] = (byte) random.nextInt(256);
            }
            taken += goesOn(Envelope.seal(altered), seed) ? 1 : 0;
        }
        assertThat(taken).as("some are taken, some refused").isBetween(100, 2900);
    }

    private static boolean goesOn(byte[] bytes, int seed) {
        Pool pool;
        try {
            pool = Pool.restore(bytes);
        } catch (IllegalArgumentException refusal) {
            assertThat(refusal).hasMessageStartingWith("Pool.restore snapshot: ");
            return false;
        }
        try {
            for (int i = 0; i < 3; i++) {
                pool.step(DT);
            }
        } catch (RuntimeException | AssertionError broken) {
            throw new AssertionError("seed " + seed, broken);
        }
        return true;
    }

    @Test
    void numbersThatAreNotFiniteAreRefused() {
        requireRefusal(b -> b.x[1] = Double.NaN, "x must be finite (m), was NaN");
        requireRefusal(b -> b.spin[2] = Double.POSITIVE_INFINITY, "spin must be finite");
        requireRefusal(b -> b.stillTime[2] = -1, "stillTime must be zero or more");
        requireRefusal(b -> b.fixtureMinX[2] = Double.NaN, "least x and y must not be over");
        requireRefusal(b -> b.velocityX[0] = 1, "static body's velocity");
        requireRefusal(b -> b.statedMass[1] = 1e200, "mass, stated or from density and area");
    }

    @Test
    void listsAndSlotsOutOfRangeAreRefused() {
        requirePairRefusal(p -> p.bodyB[0] = 77, "a pair must name bodies, was slot 77");
        requirePairRefusal(p -> p.bodyB[0] = p.bodyA[0], "a pair must be of two bodies");
        requirePairRefusal(p -> p.points[0] = 3, "points must be 0 to 2, was 3");
        requirePairRefusal(p -> Arrays.fill(p.next, 0), "is broken at");
        requirePairRefusal(p -> Arrays.fill(p.next, Pairs.NONE), "in the lists of both");
        requireRefusal(b -> b.firstPair[1] = 99, "slot 1 is broken at 99");
    }

    /** After the label: how many bodies, how many free slots, and those. */
    @Test
    void countsThatCannotBeAreRefused() {
        byte[] label = "body slots".getBytes(US_ASCII);
        requireRefusalOf(label, 8 + 3, 99, "a free slot must be 0 to 3, each once, was 99");
        requireRefusalOf(label, 0, 0x7F, "entries of 'body slots', was 2130706435");
        requireRefusalOf(label, 4, 0xFF, "entries of 'body slots', was -16777215");
        requireRefusalOf(label, 3, 99, "of 'body slots'");
        requireRefusalOf(new byte[] {0, 'D', 0, 'I', 0, 'R'}, -5, 'X', "XIRECT");
        requireRefusalOf(new byte[] {0, 'G', 0, 'r', 0, 'a'}, -5, 'g', "the effect gravity");
    }

    /** Changes one byte so many places after a run of bytes, and the checksum with it. */
    private static void requireRefusalOf(byte[] run, int after, int value, String words) {
        byte[] whole = snapshotOf(storageOfThree()).encode();
        byte[] content = Arrays.copyOfRange(whole, HEADER_BYTES, whole.length);
        content[indexOf(content, run) + run.length + after] = (byte) value;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(Envelope.seal(content)))
                .withMessageStartingWith("Pool.restore snapshot: ")
                .withMessageContaining(words);
    }

    @Test
    void bodiesAreNamedOnceEach() {
        Snapshot snapshot = snapshotOf(storageOfThree());
        snapshot.order[2] = snapshot.order[1];
        requireRefusal(snapshot, "must name slot 1 once");
        snapshot.order = new int[] {0, 1};
        requireRefusal(snapshot, "must name 3 bodies, was 2");
        snapshot.order = new int[] {0, 1, 5};
        requireRefusal(snapshot, "must name bodies, was slot 5");
    }

    /**
     * Only their kind is written of effects that hold a function: here a rotation stands for one.
     */
    @Test
    void effectThatHoldsAFunctionHasToBeHandedIn() {
        Snapshot snapshot = snapshotOf(storageOfThree());
        byte[] whole = snapshot.encode();
        byte[] content = Arrays.copyOfRange(whole, HEADER_BYTES, whole.length);
        byte[] kind = {0, 'R', 0, 'o', 0, 't', 0, 'a', 0, 't', 0, 'i', 0, 'o', 0, 'n'};
        int after = indexOf(content, kind) + kind.length;
        // The flag is set, and the four bytes go that count its numbers.
        byte[] held = Arrays.copyOf(content, content.length - 4);
        System.arraycopy(content, after + 5, held, after + 1, content.length - after - 5);
        held[after] = 1;
        byte[] sealed = Envelope.seal(held);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(sealed))
                .withMessageContaining("effects that hold a function")
                .withMessageContaining("[Rotation]");
        Pool pool = Pool.restore(sealed, Effects.usual());
        assertThat(pool.bodies()).hasSize(3);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(sealed, Effects.of()))
                .withMessageContaining("Rotation");
    }

    @Test
    void otherColumnsAreRefused() {
        byte[] whole = snapshotOf(storageOfThree()).encode();
        byte[] content = Arrays.copyOfRange(whole, HEADER_BYTES, whole.length);
        byte[] name = "gravityScale".getBytes(US_ASCII);
        content[indexOf(content, name)] = 'G';
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(Envelope.seal(content)))
                .withMessage(
                        "Pool.restore snapshot: must have 'gravityScale' after 'group', was"
                                + " 'GravityScale'");
        content[indexOf(content, "GravityScale".getBytes(US_ASCII))] = 'g';
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                Pool.restore(
                                        Envelope.seal(Arrays.copyOf(content, content.length + 1))))
                .withMessageContaining("had 1 bytes more");
    }

    private static int indexOf(byte[] bytes, byte[] part) {
        for (int at = 0; at <= bytes.length - part.length; at++) {
            if (Arrays.equals(bytes, at, at + part.length, part, 0, part.length)) {
                return at;
            }
        }
        throw new AssertionError("not found");
    }

    private static void requireRefusal(Consumer<Bodies> change, String words) {
        DataStorage data = storageOfThree();
        change.accept(data.bodies);
        requireRefusal(snapshotOf(data), words);
    }

    private static void requirePairRefusal(Consumer<Pairs> change, String words) {
        DataStorage data = storageOfThree();
        change.accept(data.pairs);
        requireRefusal(snapshotOf(data), words);
    }

    static void requireRefusal(Snapshot snapshot, String words) {
        byte[] bytes = snapshot.encode();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Pool.restore(bytes))
                .withMessageStartingWith("Pool.restore snapshot: ")
                .withMessageContaining(words);
    }

    /** A floor and two boxes on it, one of whose slots was given back in between. */
    private static DataStorage storageOfThree() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1.5));
        pool.remove(pool.add(BodyDefinition.dynamic(new Circle(1)).at(9, 9)));
        pool.step(DT);
        return Snapshot.decode(pool.snapshot(), revision -> {}).data;
    }

    private static Snapshot snapshotOf(DataStorage data) {
        Snapshot snapshot = new Snapshot(Effects.usual(), Accuracy.GAME, data);
        snapshot.order = new int[] {0, 1, 2};
        snapshot.names = new String[] {"floor", "one", "two"};
        return snapshot;
    }
}
