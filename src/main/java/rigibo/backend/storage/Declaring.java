package rigibo.backend.storage;

import rigibo.backend.effect.Effects;

import java.util.Set;

/** Makes the columns that have become necessary, and drops those that no longer are. */
final class Declaring implements ColumnVisitor {

    private final Effects effects;
    private final Set<Need> asked;
    private final int slots;

    /** Makes columns with room for a number of slots. */
    Declaring(Effects effects, Set<Need> asked, int slots) {
        this.effects = effects;
        this.asked = asked;
        this.slots = slots;
    }

    private boolean isMet(Need need) {
        return need.isMet(effects, asked);
    }

    @Override
    public <T> T[] column(String name, Role role, T[] column) {
        return column;
    }

    @Override
    public double[] column(String name, Role role, Need need, double[] column) {
        return !isMet(need) ? null : column != null ? column : new double[slots];
    }

    @Override
    public int[] column(String name, Role role, Need need, int[] column) {
        return !isMet(need) ? null : column != null ? column : new int[slots];
    }

    @Override
    public boolean[] column(String name, Role role, Need need, boolean[] column) {
        return !isMet(need) ? null : column != null ? column : new boolean[slots];
    }

    @Override
    public double[] twins(String name, Role role, Need need, double[] column) {
        return !isMet(need) ? null : column != null ? column : new double[2 * slots];
    }

    @Override
    public int[] twins(String name, Role role, Need need, int[] column) {
        return !isMet(need) ? null : column != null ? column : new int[2 * slots];
    }
}
