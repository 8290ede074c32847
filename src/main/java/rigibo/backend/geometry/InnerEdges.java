package rigibo.backend.geometry;

import java.util.ArrayList;
import java.util.List;

/**
 * Finds the edges of a compound's parts that other parts cover. A body deep in one part cannot
 * leave through such an edge, since the next part begins there.
 */
final class InnerEdges {

    /** Number of places along an edge, evenly spread, that must be covered. */
    private static final int PLACES = 16;

    /** Distance before the edge at which they are, in widths of the part. */
    private static final double BEFORE = 1e-3;

    private final List<Part> parts;
    private final Outline[] outlines;

    private InnerEdges(List<Part> parts, Outline[] outlines) {
        this.parts = parts;
        this.outlines = outlines;
    }

    static void note(List<Part> parts, Outline[] outlines) {
        InnerEdges edges = new InnerEdges(parts, outlines);
        for (int i = 0; i < outlines.length; i++) {
            edges.note(i);
        }
    }

    private void note(int part) {
        Outline outline = outlines[part];
        List<Outline> beside = solidsBeside(part);
        boolean[] inner = new boolean[outline.edges()];
        boolean isAny = false;
        for (int i = 0; i < inner.length; i++) {
            inner[i] = isCovered(outline, i, beside);
            isAny |= inner[i];
        }
        if (isAny) {
            outline.noteInner(new CoveredEdges(outline, inner, beside));
        }
    }

    private List<Outline> solidsBeside(int part) {
        List<Outline> solids = new ArrayList<>();
        for (int other = 0; other < outlines.length; other++) {
            if (other != part && !parts.get(other).isSensor()) {
                solids.add(outlines[other]);
            }
        }
        return solids;
    }

    private static boolean isCovered(Outline outline, int edge, List<Outline> others) {
        int next = (edge + 1) % outline.corners();
        double before = outline.radius() + BEFORE * outline.smallestWidth();
        for (int i = 0; i < PLACES; i++) {
            double along = (i + 0.5) / PLACES;
            double x = outline.cornerX(edge);
            double y = outline.cornerY(edge);
            x += along * (outline.cornerX(next) - x) + before * outline.normalX(edge);
            y += along * (outline.cornerY(next) - y) + before * outline.normalY(edge);
            if (!CoveredEdges.isInAny(others, x, y)) {
                return false;
            }
        }
        return true;
    }
}
