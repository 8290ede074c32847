package rigibo.frontend.gallery;

import rigibo.frontend.scene.Demonstration;

import java.util.List;
import java.util.Optional;

/**
 * A demonstration that leafs through every page of every section of the gallery and stays on each
 * for a while.
 */
final class GalleryWalk implements Demonstration {

    /** Turns for which a page is shown; its picture is saved at the end of them. */
    private static final int LOOK = 60;

    private final List<Click> ways;
    private int turn;

    /** A walk that goes from page to page by clicks; the first page needs none. */
    GalleryWalk(List<Click> ways) {
        this.ways = List.copyOf(ways);
    }

    @Override
    public Optional<Click> click() {
        turn++;
        int page = turn / LOOK;
        boolean goesOn = turn % LOOK == 0 && page <= ways.size();
        return goesOn ? Optional.of(ways.get(page - 1)) : Optional.empty();
    }

    @Override
    public Optional<String> picture() {
        boolean isKept = turn % LOOK == LOOK - 1 && turn / LOOK <= ways.size();
        return isKept ? Optional.of("page-" + (turn / LOOK + 1)) : Optional.empty();
    }

    @Override
    public boolean isOver() {
        return turn >= LOOK * (ways.size() + 1);
    }

    @Override
    public boolean hasSucceeded() {
        return isOver();
    }
}
