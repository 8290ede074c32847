package rigibo.backend.broadphase;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Found;

/**
 * Keeps the fixtures of all shapes: those of moving bodies, if not too large, in a grid, all others
 * in a tree. The grid is quick to change, but answers only boxes not much larger than its fixtures.
 * The tree answers rays and boxes of any size, and fixtures that stay in it cost nothing.
 *
 * <p>Results do not depend on where a fixture is kept, so steps do not depend on it, either.
 */
final class FixtureStore {

    /** Value in place of a leaf: the fixture is in the grid. */
    private static final int IN_GRID = -1;

    private final Bodies bodies;
    private final FixtureTree tree = new FixtureTree();
    private final FixtureGrid grid = new FixtureGrid();
    private final FixtureSearch search = new FixtureSearch(tree);
    private final GridBranch branch = new GridBranch(tree, grid);
    private final Found found = new Found();

    /** Whether searches of the tree include the fixtures in the grid. */
    private boolean isGathered = true;

    FixtureStore(Bodies bodies) {
        this.bodies = bodies;
    }

    void add(int slot) {
        bodies.leaf[slot] =
                tree.insert(
                        slot,
                        bodies.fixtureMinX[slot],
                        bodies.fixtureMinY[slot],
                        bodies.fixtureMaxX[slot],
                        bodies.fixtureMaxY[slot]);
        change();
    }

    /** Takes the branch over the grid's fixtures off the tree, since it is out of date. */
    private void change() {
        if (isGathered) {
            tree.forgetSearched();
            isGathered = false;
        }
    }

    void remove(int slot) {
        if (bodies.leaf[slot] == IN_GRID) {
            grid.remove(slot);
        } else {
            tree.remove(bodies.leaf[slot]);
        }
        change();
    }

    /** Takes over the new fixture of a shape. */
    void move(int body, int slot) {
        if (bodies.isMoved(body) && putIntoGrid(slot)) {
            if (bodies.leaf[slot] != IN_GRID) {
                tree.remove(bodies.leaf[slot]);
                bodies.leaf[slot] = IN_GRID;
            }
        } else if (bodies.leaf[slot] == IN_GRID) {
            grid.remove(slot);
            add(slot);
        } else {
            tree.move(
                    bodies.leaf[slot],
                    bodies.fixtureMinX[slot],
                    bodies.fixtureMinY[slot],
                    bodies.fixtureMaxX[slot],
                    bodies.fixtureMaxY[slot]);
        }
        change();
    }

    private boolean putIntoGrid(int slot) {
        return grid.put(
                slot,
                bodies.fixtureMinX[slot],
                bodies.fixtureMinY[slot],
                bodies.fixtureMaxX[slot],
                bodies.fixtureMaxY[slot]);
    }

    /** Moves the fixture of a shape that came to rest to the tree, where it costs nothing. */
    void settle(int slot) {
        if (bodies.leaf[slot] == IN_GRID) {
            grid.remove(slot);
            add(slot);
        }
    }

    /** The slots, ascending, of all shapes whose fixture shares a point with that of a shape. */
    Found meet(int slot) {
        double minX = bodies.fixtureMinX[slot];
        double minY = bodies.fixtureMinY[slot];
        double maxX = bodies.fixtureMaxX[slot];
        double maxY = bodies.fixtureMaxY[slot];
        found.clear();
        search.collect(minX, minY, maxX, maxY, found);
        grid.query(minX, minY, maxX, maxY, found);
        if (found.count > 1) {
            found.sort();
            found.dropRepeated();
        }
        return found;
    }

    /** Number of fixtures in the grid. */
    int inGrid() {
        return grid.count();
    }

    /** Number of boxes in the grid that were compared with others. */
    long looked() {
        return grid.looked();
    }

    /** The tree with all fixtures, valid until the next one changes. */
    FixtureTree searchedTree() {
        if (!isGathered) {
            branch.hang();
            isGathered = true;
        }
        return tree;
    }

    /** A search of all fixtures by box and by ray, valid until the next one changes. */
    FixtureSearch search() {
        searchedTree();
        return search;
    }
}
