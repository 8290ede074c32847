package rigibo.backend.storage;

/** Drops all columns of a table. */
final class NoColumns implements ColumnVisitor {

    @Override
    public <T> T[] column(String name, Role role, T[] column) {
        return null;
    }

    @Override
    public double[] column(String name, Role role, Need need, double[] column) {
        return null;
    }

    @Override
    public int[] column(String name, Role role, Need need, int[] column) {
        return null;
    }

    @Override
    public boolean[] column(String name, Role role, Need need, boolean[] column) {
        return null;
    }

    @Override
    public double[] twins(String name, Role role, Need need, double[] column) {
        return null;
    }

    @Override
    public int[] twins(String name, Role role, Need need, int[] column) {
        return null;
    }
}
