package rigibo.frontend.scene;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Polygon;

import java.util.ArrayList;
import java.util.List;

/**
 * The drawn part of a chain's matter: a band along the chain, equally thick at every edge, mitred
 * at the corners. A line without thickness would hardly be visible and would not distinguish its
 * sides.
 */
public final class ChainBand {

    /** Thickness of the band, as a share of the chain's extent, and its bounds, m. */
    private static final double SHARE = 0.04;

    private static final double THINNEST = 0.04;
    private static final double THICKEST = 0.35;

    /** Longest mitre, in thicknesses of the band. */
    private static final double LONGEST_MITRE = 2;

    /**
     * The band along an edge.
     *
     * @param polygon about its own middle
     * @param x of that middle in the chain's frame, m
     * @param y of that middle in the chain's frame, m
     */
    public record Piece(Polygon polygon, double x, double y) {}

    private final Chain chain;
    private final double thickness;

    private ChainBand(Chain chain) {
        this.chain = chain;
        double wanted = SHARE * chain.boundingRadius();
        thickness = Math.max(THINNEST, Math.min(THICKEST, wanted));
    }

    /** A piece for each edge, in their order. */
    public static List<Piece> of(Chain chain) {
        ChainBand band = new ChainBand(chain);
        List<Piece> pieces = new ArrayList<>();
        for (int edge = 0; edge < chain.parts(); edge++) {
            pieces.add(band.piece(edge));
        }
        return pieces;
    }

    /** Where a mitre would cross the other, the rubber band round both still covers the edge. */
    private Piece piece(int edge) {
        int next = (edge + 1) % chain.corners();
        double[] from = inner(edge, edge - 1, edge);
        double[] to = inner(next, edge, edge + 1);
        Polygon quad =
                Polygon.hull(
                        chain.cornerX(edge),
                        chain.cornerY(edge),
                        chain.cornerX(next),
                        chain.cornerY(next),
                        to[0],
                        to[1],
                        from[0],
                        from[1]);
        return new Piece(quad, quad.centroidX(), quad.centroidY());
    }

    /** The point of the matter behind a corner between two edges; either is missing at an end. */
    private double[] inner(int corner, int before, int after) {
        double[] first = intoMatter(before);
        double[] second = intoMatter(after);
        double[] one = first == null ? second : first;
        double[] other = second == null ? first : second;
        double cosine = one[0] * other[0] + one[1] * other[1];
        double reach = thickness / Math.max(1 / LONGEST_MITRE, 1 + cosine);
        return new double[] {
            chain.cornerX(corner) + reach * (one[0] + other[0]),
            chain.cornerY(corner) + reach * (one[1] + other[1])
        };
    }

    /** The unit normal of an edge into the matter, which is to its left; null beyond an end. */
    private double[] intoMatter(int edge) {
        int count = chain.parts();
        if (!chain.isLoop() && (edge < 0 || edge >= count)) {
            return null;
        }
        int at = Math.floorMod(edge, count);
        int next = (at + 1) % chain.corners();
        double dx = chain.cornerX(next) - chain.cornerX(at);
        double dy = chain.cornerY(next) - chain.cornerY(at);
        double length = Math.hypot(dx, dy);
        return new double[] {-dy / length, dx / length};
    }
}
