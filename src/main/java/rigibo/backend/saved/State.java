package rigibo.backend.saved;

import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.ColumnVisitor;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Need;
import rigibo.backend.storage.Role;
import rigibo.backend.storage.Slots;
import rigibo.backend.storage.Visits;

import java.util.Arrays;
import java.util.Map;

/**
 * Passes to a codec all columns of a pool that last from step to step: those with the role SAVED,
 * in the order of their tables.
 */
final class State implements ColumnVisitor {

    private static final Map<Class<?>, Form<?>> FORMS =
            Map.of(
                    BodyType[].class, Form.BODY_TYPE,
                    Shape[].class, Form.SHAPE,
                    Material[].class, Form.MATERIAL);

    /** Lower bound on the bytes of any body or pair when written. */
    private static final int LEAST_BYTES = 100;

    private static final int NUMBER_BYTES = 4;

    private final Codec codec;

    /** Slots in use of the present table, ascending. */
    private int[] rows = {};

    private State(Codec codec) {
        this.codec = codec;
    }

    /** Passes all bodies, pairs, joints and visits to a codec, which may replace their values. */
    static void visit(DataStorage data, Codec codec) {
        State state = new State(codec);
        // Only the ordinal of a type is written, so the label names the types in order.
        codec.label("body types " + Arrays.toString(BodyType.values()));
        data.bodies.reserve(state.visitSlots("body slots", data.bodies.slots));
        data.bodies.visitColumns(state);
        data.pairs.reserve(state.visitSlots("pair slots", data.pairs.slots));
        data.pairs.visitColumns(state);
        // A hash skips a table that was never used, since declaring joints alone changes nothing.
        boolean isHash = codec instanceof StateHash;
        if (data.joints != null && !(isHash && data.joints.slots.high == 0)) {
            data.joints.reserve(state.visitSlots("joint slots", data.joints.slots));
            data.joints.visitColumns(state);
        }
        if (data.visits != null) {
            visitVisits(data.visits, codec);
        }
    }

    private static void visitVisits(Visits visits, Codec codec) {
        codec.label("visits");
        int count = codec.count(visits.count, 3 * NUMBER_BYTES);
        int known = visits.count;
        for (int i = 0; i < count; i++) {
            boolean isKnown = i < known;
            int sensor = codec.number(isKnown ? visits.sensor[i] : 0);
            int visitor = codec.number(isKnown ? visits.visitor[i] : 0);
            int now = codec.number(isKnown ? visits.state[i] : 0);
            if (!isKnown) {
                visits.add(sensor, visitor, now);
            }
        }
    }

    /**
     * Passes the number of slots and the free ones, in the order in which they will be assigned;
     * returns the number of slots.
     */
    private int visitSlots(String name, Slots slots) {
        codec.label(name);
        int inUse = codec.count(slots.inUse(), LEAST_BYTES);
        int freeCount = codec.count(slots.freeCount, NUMBER_BYTES);
        slots.high = inUse + freeCount;
        slots.freeCount = freeCount;
        slots.reserveFree();
        for (int i = 0; i < freeCount; i++) {
            slots.free[i] = codec.number(slots.free[i]);
        }
        rows = slots.occupied();
        return slots.high;
    }

    @Override
    @SuppressWarnings("unchecked") // A column holds values of its own form.
    public <T> T[] column(String name, Role role, T[] column) {
        if (role == Role.SAVED) {
            codec.label(name);
            Form<T> form = (Form<T>) FORMS.get(column.getClass());
            for (int slot : rows) {
                column[slot] = codec.value(form, column[slot]);
            }
        }
        return column;
    }

    @Override
    public double[] column(String name, Role role, Need need, double[] column) {
        return column(name, role, need, column, null);
    }

    @Override
    public double[] column(String name, Role role, Need need, double[] column, double[] idle) {
        if (isShown(role, column) && isUsed(name, need, column, idle)) {
            codec.label(name);
            for (int slot : rows) {
                column[slot] = codec.number(column[slot]);
            }
        }
        return column;
    }

    private static boolean isShown(Role role, Object column) {
        return role == Role.SAVED && column != null;
    }

    private boolean isUsed(String name, Need need, double[] column, double[] idle) {
        return need == Need.ALWAYS || codec.keeps(name, column, idle, rows);
    }

    @Override
    public int[] column(String name, Role role, Need need, int[] column) {
        if (isShown(role, column)) {
            codec.label(name);
            for (int slot : rows) {
                column[slot] = codec.number(column[slot]);
            }
        }
        return column;
    }

    @Override
    public boolean[] column(String name, Role role, Need need, boolean[] column) {
        if (isShown(role, column)) {
            codec.label(name);
            for (int slot : rows) {
                column[slot] = codec.flag(column[slot]);
            }
        }
        return column;
    }

    @Override
    public double[] twins(String name, Role role, Need need, double[] column) {
        if (isShown(role, column)) {
            codec.label(name);
            for (int slot : rows) {
                column[2 * slot] = codec.number(column[2 * slot]);
                column[2 * slot + 1] = codec.number(column[2 * slot + 1]);
            }
        }
        return column;
    }

    @Override
    public int[] twins(String name, Role role, Need need, int[] column) {
        if (isShown(role, column)) {
            codec.label(name);
            for (int slot : rows) {
                column[2 * slot] = codec.number(column[2 * slot]);
                column[2 * slot + 1] = codec.number(column[2 * slot + 1]);
            }
        }
        return column;
    }
}
