package rigibo.backend.saved;

import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Need;

import java.util.Arrays;
import java.util.function.Function;
import java.util.function.IntConsumer;

/** The complete state of a pool between steps, which can be written as bytes and read back. */
public final class Snapshot {

    /** Revision of the present simulation; see {@code Pool.REVISION}. */
    public static final int REVISION = 42;

    /** Bytes of a body's slot and of the length of its name. */
    private static final int LEAST_BYTES = 8;

    private static final String REVISION_LABEL = "revision";

    public final Effects effects;
    public final DataStorage data;
    public Accuracy accuracy;

    /** Time, s since the pool was made. */
    public double time;

    /** Slots of the bodies in the order in which they were added, and their names. */
    public int[] order = {};

    public String[] names = {};

    /** Slots of the joints in the order in which they were added. */
    public int[] jointOrder = {};

    /** Contacts that edits removed from the pairs. */
    public SavedContact[] ended = {};

    /** A snapshot of the effects, the accuracy and the columns of a pool. */
    public Snapshot(Effects effects, Accuracy accuracy, DataStorage data) {
        this.effects = effects;
        this.accuracy = accuracy;
        this.data = data;
    }

    /** Writes this snapshot as bytes. */
    public byte[] encode() {
        ByteWriter writer = new ByteWriter();
        writer.label(REVISION_LABEL);
        writer.number(REVISION);
        SavedEffects.write(effects, writer);
        visit(writer);
        return Envelope.seal(writer.bytes());
    }

    /**
     * Reads bytes from {@link #encode}. Derived columns are left empty.
     *
     * @param revision receives the revision before anything else is read, and may reject it by an
     *     exception
     * @throws IllegalArgumentException when the bytes were altered, state an impossible pool, or
     *     declare an effect that holds a function
     */
    public static Snapshot decode(byte[] bytes, IntConsumer revision) {
        return decode(bytes, revision, SavedEffects::declared);
    }

    /**
     * Reads bytes from {@link #encode}, with the caller's effects in place of those declared.
     *
     * @throws IllegalArgumentException when the bytes were altered, state an impossible pool, or
     *     declare effects of other kinds
     */
    public static Snapshot decode(byte[] bytes, IntConsumer revision, Effects given) {
        return decode(bytes, revision, saved -> saved.replacedBy(given));
    }

    /**
     * The revision of the simulation that wrote a snapshot.
     *
     * @throws IllegalArgumentException when the bytes were altered
     */
    public static int revision(byte[] bytes) {
        return readRevision(Envelope.open(bytes));
    }

    private static int readRevision(ByteReader reader) {
        reader.label(REVISION_LABEL);
        return reader.number(0);
    }

    private static Snapshot decode(
            byte[] bytes, IntConsumer revision, Function<SavedEffects, Effects> choice) {
        ByteReader reader = Envelope.open(bytes);
        revision.accept(readRevision(reader));
        Effects effects = choice.apply(SavedEffects.read(reader));
        Snapshot read = new Snapshot(effects, Accuracy.GAME, new DataStorage(effects));
        read.visit(reader);
        reader.requireEnd();
        SnapshotCheck.require(read);
        return read;
    }

    private void visit(Codec codec) {
        accuracy = SavedAccuracy.visit(accuracy, codec);
        codec.label("time");
        time = codec.number(time);
        // No column tells which forces vary along the path, only whether their columns exist.
        data.bodies.integratePaths(codec.flag(data.bodies.integratesPaths()));
        for (Need need : Need.OF_BODIES) {
            if (codec.flag(data.bodies.holds(need))) {
                data.hold(need);
            }
        }
        State.visit(data, codec);
        codec.label("bodies in the order they were added");
        reserve(codec.count(order.length, LEAST_BYTES));
        for (int i = 0; i < order.length; i++) {
            order[i] = codec.number(order[i]);
            names[i] = codec.text(names[i]);
        }
        codec.label("contacts that ended between steps");
        int count = codec.count(ended.length, SavedContact.BYTES);
        if (ended.length != count) {
            ended = new SavedContact[count];
            Arrays.fill(ended, SavedContact.UNREAD);
        }
        for (int i = 0; i < count; i++) {
            ended[i] = ended[i].visit(codec);
        }
        if (data.joints != null) {
            visitJointOrder(codec);
        }
    }

    private void visitJointOrder(Codec codec) {
        codec.label("joints in the order they were joined");
        int count = codec.count(jointOrder.length, Integer.BYTES);
        if (jointOrder.length != count) {
            jointOrder = new int[count];
        }
        for (int i = 0; i < count; i++) {
            jointOrder[i] = codec.number(jointOrder[i]);
        }
    }

    private void reserve(int count) {
        if (order.length != count) {
            order = new int[count];
            names = new String[count];
        }
    }
}
