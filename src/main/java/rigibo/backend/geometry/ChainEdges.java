package rigibo.backend.geometry;

/** Makes the outlines of a chain's edges, each of which knows what lies beyond its ends. */
final class ChainEdges {

    private final double[] xy;
    private final boolean isLoop;
    private final int edges;

    /** Outward normals, and lengths in m. */
    private final double[] normalX;

    private final double[] normalY;
    private final double[] length;

    private ChainEdges(double[] xy, boolean isLoop) {
        this.xy = xy;
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

    /** What lies beyond every edge, one way along the chain. */
    private EdgeEnd[] beyond(int way) {
        double whole = 0;
        for (double one : length) {
            whole += one;
        }
        EdgeEnd[] ends = new EdgeEnd[edges];
        double run = 0;
        double straight = 0;
        // Against the way, so that what is beyond is known; round a loop twice.
        for (int i = 0; i < (isLoop ? 2 * edges : edges); i++) {
            int edge = way > 0 ? Math.floorMod(edges - 1 - i, edges) : i % edges;
            int next = edge + way;
            if (!isLoop && (next < 0 || next == edges)) {
                // Out along the edge, which is its normal turned by a right angle.
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

    /** The sine of the turn away from the air at the far end of an edge; all of it at an end. */
    private double turn(int edge, int way) {
        if (!isLoop && (edge + way < 0 || edge + way == edges)) {
            return 1;
        }
        int next = Math.floorMod(edge + way, edges);
        return way * (normalX[edge] * normalY[next] - normalY[edge] * normalX[next]);
    }
}
