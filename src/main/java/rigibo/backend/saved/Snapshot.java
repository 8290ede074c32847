package rigibo.backend.saved;

import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Need;

import java.util.Arrays;
import java.util.function.Function;
import java.util.function.IntConsumer;

/** All of a pool that lasts from step to step, to be written as bytes and read again. */
public final class Snapshot {

    /** Of the simulation at present; see {@code Pool.REVISION}. */
    public static final int REVISION = 14;

    /** A body's slot, and how many characters its name has. */
    private static final int LEAST_BYTES = 8;

    private static final String REVISION_LABEL = "revision";

    public final Effects effects;
    public final DataStorage data;
    public Accuracy accuracy;

    /** s since the pool was made. */
    public double time;

    /** Slots of the bodies in the order they were added, and their names. */
    public int[] order = {};

    public String[] names = {};

    /** Slots of the joints in the order they were joined. */
    public int[] jointOrder = {};

    /** What edits took from the pairs. */
    public SavedContact[] ended = {};

    /** A snapshot of what a pool simulates, how exactly, and its columns. */
    public Snapshot(Effects effects, Accuracy accuracy, DataStorage data) {
        this.effects = effects;
        this.accuracy = accuracy;
        this.data = data;
    }

    /** Writes it. */
    public byte[] encode() {
        ByteWriter writer = new ByteWriter();
        writer.label(REVISION_LABEL);
        writer.number(REVISION);
        SavedEffects.write(effects, writer);
        visit(writer);
        return Envelope.seal(writer.bytes());
    }

    /**
     * Reads what {@link #encode} wrote. Columns that follow from others are left empty.
     *
     * @param revision is told of which revision it is before anything else is read, and may refuse
     * @throws IllegalArgumentException when it was altered, states what cannot be, or declares an
     *     effect that holds a function
     */
    public static Snapshot decode(byte[] bytes, IntConsumer revision) {
        return decode(bytes, revision, SavedEffects::declared);
    }

    /**
     * Reads what {@link #encode} wrote, with the caller's effects in place of those declared.
     *
     * @throws IllegalArgumentException when it was altered, states what cannot be, or the effects
     *     are not of the kinds it declares
     */
    public static Snapshot decode(byte[] bytes, IntConsumer revision, Effects given) {
        return decode(bytes, revision, saved -> saved.replacedBy(given));
    }

    /**
     * Of which revision of the simulation a snapshot is.
     *
     * @throws IllegalArgumentException when it was altered
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
        // Which forces change along the way no column tells, but whether those of such are there.
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
