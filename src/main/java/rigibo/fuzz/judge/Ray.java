package rigibo.fuzz.judge;

import static rigibo.fuzz.judge.LawBroken.unless;

import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Length;

import java.util.Optional;

/** A ray, with the bounds on its answer from every body that it may hit. */
record Ray(double fromX, double fromY, double toX, double toY) {

    private static final String FIRST = "a ray meets the first body on its way";

    /**
     * The length of a way through a body below which round-off decides, in widths of the
     * uncertainty.
     */
    private static final double CLEARLY = 10;

    void requireHit(Pool pool, Optional<RayHit> hit) {
        hit.filter(met -> Outline.isKnown(met.body())).ifPresent(this::requireOnOutline);
        double first = hit.map(RayHit::fraction).orElse(Double.POSITIVE_INFINITY);
        for (RigidBody body : pool.bodies()) {
            double enters =
                    Outline.isKnown(body)
                            ? clearlyEnters(new Outline(body))
                            : Double.POSITIVE_INFINITY;
            unless(
                    enters >= Math.min(first, 1),
                    FIRST,
                    "%s enters %s at %s, told is %s",
                    this,
                    body,
                    enters,
                    hit);
        }
    }

    private void requireOnOutline(RayHit hit) {
        Outline outline = new Outline(hit.body());
        double off = Math.abs(outline.depth(hit.x(), hit.y()));
        unless(
                !(off > outline.slack(fromX, fromY, toX, toY)),
                FIRST,
                "%s is %s m off the outline",
                hit,
                off);
        unless(hit.fraction() >= 0 && hit.fraction() <= 1, FIRST, "%s", hit);
        double square = hit.normalX() * hit.normalX() + hit.normalY() * hit.normalY();
        unless(Math.abs(square - 1) <= 1e-9, FIRST, "normal of %s", hit);
    }

    /**
     * The share of the ray after which it is certainly inside a body; above 1 if it never is, or if
     * it begins in the body or close to it.
     */
    private double clearlyEnters(Outline outline) {
        double alongX = toX - fromX;
        double alongY = toY - fromY;
        double length = Length.hypot(alongX, alongY);
        double slack = CLEARLY * outline.slack(fromX, fromY, toX, toY);
        double[] inside = outline.inside(fromX, fromY, alongX, alongY);
        double middle = (Math.max(inside[0], 0) + Math.min(inside[1], 1)) / 2;
        boolean isClear =
                outline.depth(fromX, fromY) < -slack
                        && inside[0] >= 0
                        && inside[1] > inside[0]
                        && outline.depth(fromX + middle * alongX, fromY + middle * alongY) > slack;
        return isClear ? inside[0] + slack / length : Double.POSITIVE_INFINITY;
    }
}
