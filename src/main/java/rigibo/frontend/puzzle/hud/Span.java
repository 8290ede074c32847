package rigibo.frontend.puzzle.hud;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.frontend.scene.Camera;

import java.util.ArrayList;
import java.util.List;

/**
 * A range of heights on the screen.
 *
 * @param top px
 * @param bottom px, below it
 */
record Span(double top, double bottom) {

    /** Distance from the edges of the room and from visible parts, px. */
    static final double GAP = 12;

    /** The heights of a body. */
    static Span of(RigidBody body, Camera camera) {
        Aabb bounds = new Aabb();
        double angle = body.angle();
        body.shape().bounds(body.x(), body.y(), Math.cos(angle), Math.sin(angle), bounds);
        return new Span(camera.screenY(bounds.maxY), camera.screenY(bounds.minY));
    }

    /** Length of another range that it covers, px. */
    private double covers(Span other) {
        return Math.max(0, Math.min(bottom, other.bottom) - Math.max(top, other.top));
    }

    /**
     * The upper edge, within these heights, of a part of some height that covers the least of the
     * ranges to keep visible; the highest of several.
     */
    double clearTop(double height, List<Span> kept) {
        double highest = top + GAP;
        double lowest = bottom - GAP - height;
        List<Double> tops = new ArrayList<>(List.of(highest));
        kept.forEach(span -> tops.add(span.bottom + GAP));
        kept.forEach(span -> tops.add(span.top - GAP - height));
        tops.add(lowest);
        double best = highest;
        double least = Double.POSITIVE_INFINITY;
        for (double at : tops) {
            Span tried = new Span(at, at + height);
            double covered = kept.stream().mapToDouble(tried::covers).sum();
            boolean isWithin = at == highest || at >= highest && at <= lowest;
            boolean isBetter = covered < least || covered == least && at < best;
            if (isWithin && isBetter) {
                best = at;
                least = covered;
            }
        }
        return best;
    }
}
