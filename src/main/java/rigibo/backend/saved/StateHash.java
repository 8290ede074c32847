package rigibo.backend.saved;

import rigibo.backend.storage.DataStorage;

import java.util.List;

/**
 * A 64-bit hash of every bit that the future depends on: the time and all that {@link State} lists.
 * What is simulated and how exactly are not folded in, and neither are names.
 */
public final class StateHash implements Codec {

    private long hash = Bits.SEED;

    private StateHash() {}

    /** The hash of a pool's data at a time in s, and of the contacts that edits took from them. */
    public static long of(DataStorage data, double time, List<SavedContact> ended) {
        StateHash state = new StateHash();
        state.number(time);
        State.visit(data, state);
        ended.forEach(contact -> contact.visit(state));
        return state.hash;
    }

    @Override
    public void label(String name) {
        // Names are not state.
    }

    /** What a declared effect keeps and does not use is as if it were not declared. */
    @Override
    public boolean keeps(String name, double[] column, double[] idle, int[] rows) {
        for (int row : rows) {
            if (column[row] != (idle == null ? 0 : idle[row])) {
                text(name);
                return true;
            }
        }
        return false;
    }

    @Override
    public int number(int value) {
        hash = Bits.fold(hash, value);
        return value;
    }

    @Override
    public double number(double value) {
        hash = Bits.fold(hash, Double.doubleToRawLongBits(value));
        return value;
    }

    @Override
    public boolean flag(boolean value) {
        number(value ? 1 : 0);
        return value;
    }

    @Override
    public String text(String value) {
        value.chars().forEach(this::number);
        return value;
    }

    @Override
    public int count(int entries, int leastBytes) {
        return number(entries);
    }

    /** Number by number: the hash code of a record may differ from JVM to JVM. */
    @Override
    public <T> T value(Form<T> form, T value) {
        for (double number : form.numbers().apply(value)) {
            number(number);
        }
        return value;
    }
}
