package rigibo.backend.contact.solve;

/** Used where neither friction nor rolling resistance is declared: does nothing. */
public final class NoRubbing implements Rubbing {

    @Override
    public void begin(double firstKick) {}

    @Override
    public void refresh() {}

    @Override
    public int rowCount() {
        return 0;
    }

    @Override
    public void store(double h) {}
}
