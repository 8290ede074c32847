package rigibo.backend.broadphase;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Found;

/**
 * Keeps the fixtures of all shapes: of what moves, if not too large, in a grid, all others in a
 * tree. The grid is quick to change, and answers only boxes not much larger than its fixtures; the
 * tree answers rays and boxes of any size, and what it holds costs nothing while it stays.
 *
 * <p>Where a fixture is kept makes no difference to what is found, so that no step depends on it.
 */
final class FixtureStore {

    /** In place of a leaf: the fixture is in the grid. */
    private static final int IN_GRID = -1;

    private final Bodies bodies;
    private final FixtureTree tree = new FixtureTree();
    private final FixtureGrid grid = new FixtureGrid();
    private final FixtureSearch search = new FixtureSearch(tree);
    private final GridBranch branch = new GridBranch(tree, grid);
    private final Found found = new Found();

    /** Whether searches of the tree go through what is in the grid, too. */
    private boolean isGathered = true;

    FixtureStore(Bodies bodies) {
        this.bodies = bodies;
    }

    /** Adds the fixture of a shape. */
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

    /** From now on the branch of what is in the grid is not that any more. */
    private void change() {
        if (isGathered) {
            tree.forgetSearched();
            isGathered = false;
        }
    }

    /** Removes the fixture of a shape. */
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

    /** Puts the fixture of a shape that came to rest where it costs nothing. */
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

    /** The tree, through which all fixtures are found until the next one changes. */
    FixtureTree searchedTree() {
        if (!isGathered) {
            branch.hang();
            isGathered = true;
        }
        return tree;
    }

    /** Searches all fixtures by box and by ray, until the next one changes. */
    FixtureSearch search() {
        searchedTree();
        return search;
    }
}
