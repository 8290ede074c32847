package rigibo.backend.saved;

import rigibo.backend.storage.DataStorage;

import java.util.List;

/**
 * A 64-bit hash of every bit that decides the future: the time and all columns that {@link State}
 * lists. Effects, accuracy and names do not enter it.
 */
public final class StateHash implements Codec {

    private long hash = Bits.SEED;

    private StateHash() {}

    /** The hash of a pool's data at a time in s, and of the contacts that edits removed. */
    public static long of(DataStorage data, double time, List<SavedContact> ended) {
        StateHash state = new StateHash();
        state.number(time);
        State.visit(data, state);
        ended.forEach(contact -> contact.visit(state));
        return state.hash;
    }

    @Override
    public void label(String name) {
        // Names are not part of the state.
    }

    /**
     * The column of a declared effect that does nothing is left out, as if the effect were not
     * declared.
     */
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

    /** Folds in number by number, because the hash code of a record may differ between JVMs. */
    @Override
    public <T> T value(Form<T> form, T value) {
        for (double number : form.numbers().apply(value)) {
            number(number);
        }
        return value;
    }
}
