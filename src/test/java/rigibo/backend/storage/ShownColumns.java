package rigibo.backend.storage;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.UnaryOperator;

/** Visits the columns of a table and does something to each. */
public final class ShownColumns implements ColumnVisitor {

    /** By name, in the order of the table; twice the same name is refused. */
    public final Map<String, Shown> all = new LinkedHashMap<>();

    private final UnaryOperator<Object> answer;

    /**
     * One line of a table.
     *
     * @param perSlot values of each slot
     * @param array null where it is not needed
     */
    public record Shown(Role role, Need need, int perSlot, Object array) {}

    private ShownColumns(UnaryOperator<Object> answer) {
        this.answer = answer;
    }

    /** The bodies' columns, as they are. */
    public static Map<String, Shown> of(Bodies bodies) {
        ShownColumns shown = answering(UnaryOperator.identity());
        bodies.visitColumns(shown);
        return shown.all;
    }

    /** The pairs' columns, as they are. */
    public static Map<String, Shown> of(Pairs pairs) {
        ShownColumns shown = answering(UnaryOperator.identity());
        pairs.visitColumns(shown);
        return shown.all;
    }

    /** A visitor that replaces every column that exists. */
    static ShownColumns answering(UnaryOperator<Object> answer) {
        return new ShownColumns(answer);
    }

    @SuppressWarnings("unchecked") // Whoever answers answers an array of the same type.
    private <A> A show(String name, Role role, Need need, int perSlot, A column) {
        if (all.put(name, new Shown(role, need, perSlot, column)) != null) {
            throw new AssertionError(name + " is shown twice");
        }
        return column == null ? null : (A) answer.apply(column);
    }

    @Override
    public <T> T[] column(String name, Role role, T[] column) {
        return show(name, role, Need.ALWAYS, 1, column);
    }

    @Override
    public double[] column(String name, Role role, Need need, double[] column) {
        return show(name, role, need, 1, column);
    }

    @Override
    public int[] column(String name, Role role, Need need, int[] column) {
        return show(name, role, need, 1, column);
    }

    @Override
    public boolean[] column(String name, Role role, Need need, boolean[] column) {
        return show(name, role, need, 1, column);
    }

    @Override
    public double[] twins(String name, Role role, Need need, double[] column) {
        return show(name, role, need, 2, column);
    }

    @Override
    public int[] twins(String name, Role role, Need need, int[] column) {
        return show(name, role, need, 2, column);
    }
}
