package rigibo.backend.geometry;

/** Makes the outlines of a chain's edges, each with its neighbours at both ends. */
final class ChainEdges {

    private final boolean isLoop;
    private final int edges;

    /** By edge: outward unit normal, and length in m. */
    private final double[] normalX;

    private final double[] normalY;
    private final double[] length;

    private ChainEdges(double[] xy, boolean isLoop) {
        this.isLoop = isLoop;
        edges = xy.length / 2 - (isLoop ? 0 : 1);
        normalX = new double[edges];
        normalY = new double[edges];
        length = new double[edges];
        for (int i = 0; i < edges; i++) {
            double ex = xy[(2 * i + 2) % xy.length] - xy[2 * i];
            double ey = xy[(2 * i + 3) % xy.length] - xy[2 * i + 1];
            length[i] = Math.sqrt(ex * ex + ey * ey);
            normalX[i] = ey / length[i];
            normalY[i] = -ex / length[i];
        }
    }

    static Outline[] of(double[] xy, boolean isLoop) {
        ChainEdges all = new ChainEdges(xy, isLoop);
        EdgeEnd[] before = all.beyond(-1);
        EdgeEnd[] after = all.beyond(1);
        Outline[] outlines = new Outline[all.edges];
        for (int i = 0; i < all.edges; i++) {
            int next = (i + 1) % (xy.length / 2);
            outlines[i] =
                    Outline.ofEdge(
                            new double[] {xy[2 * i], xy[2 * next]},
                            new double[] {xy[2 * i + 1], xy[2 * next + 1]},
                            before[i],
                            after[i]);
        }
        return outlines;
    }

    /**
     * Finds, for every edge, what follows it: in the chain's order for {@code way} 1, in reverse
     * for −1.
     */
    private EdgeEnd[] beyond(int way) {
        double whole = 0;
        for (double one : length) {
            whole += one;
        }
        EdgeEnd[] ends = new EdgeEnd[edges];
        double run = 0;
        double straight = 0;
        // Runs against that direction, so that the next edge's values are known; a loop takes two
        // rounds.
        for (int i = 0; i < (isLoop ? 2 * edges : edges); i++) {
            int edge = way > 0 ? Math.floorMod(edges - 1 - i, edges) : i % edges;
            int next = edge + way;
            if (!isLoop && (next < 0 || next == edges)) {
                // At an open end the normal points out along the edge: it is the edge's normal
                // turned by 90°.
                ends[edge] = new EdgeEnd(-way * normalY[edge], way * normalX[edge], 0, 0);
                run = 0;
                straight = 0;
            } else {
                next = Math.floorMod(next, edges);
                run =
                        Math.min(
                                whole,
                                length[next] + (turn(next, way) <= Outline.STRAIGHT ? run : 0));
                straight =
                        Math.abs(turn(edge, way)) <= Outline.STRAIGHT ? length[next] + straight : 0;
                ends[edge] = new EdgeEnd(normalX[next], normalY[next], run, straight);
            }
        }
        return ends;
    }

    /** Sine of the turn away from the air at the far end of an edge; 1 at an open end. */
    private double turn(int edge, int way) {
        if (!isLoop && (edge + way < 0 || edge + way == edges)) {
            return 1;
        }
        int next = Math.floorMod(edge + way, edges);
        return way * (normalX[edge] * normalY[next] - normalY[edge] * normalX[next]);
    }
}
