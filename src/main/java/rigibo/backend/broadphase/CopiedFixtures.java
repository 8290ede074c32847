package rigibo.backend.broadphase;

/** A copy of the fixtures of a broad phase, which any number of threads may search at once. */
public final class CopiedFixtures {

    private final FixtureTree tree = new FixtureTree();

    /** Copies the present fixtures; no search may run meanwhile. */
    public void copy(Broadphase from) {
        tree.copy(from.store().searchedTree());
    }

    /** A search for one thread, valid until the next copy. */
    public FixtureSearch search() {
        return new FixtureSearch(tree);
    }
}
