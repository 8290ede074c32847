package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;

/** Manifold of two discs: one point on the line between the centres. */
final class CircleCircle {

    private CircleCircle() {}

    static int collide(Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        double centreAX = poseA.worldX(a.cornerX(0), a.cornerY(0));
        double centreAY = poseA.worldY(a.cornerX(0), a.cornerY(0));
        double dx = poseB.worldX(b.cornerX(0), b.cornerY(0)) - centreAX;
        double dy = poseB.worldY(b.cornerX(0), b.cornerY(0)) - centreAY;
        double radii = a.radius() + b.radius();
        double squared = dx * dx + dy * dy;
        double far = radii + reach;
        if (squared > far * far) {
            return 0;
        }
        double distance = Math.sqrt(squared);
        if (distance > 0) {
            out.normal(dx / distance, dy / distance, NormalSource.CLOSEST_POINTS);
        } else {
            // For concentric discs any axis would do; this one equals its mirror image in x.
            out.normal(0, 1, NormalSource.CLOSEST_POINTS);
        }
        double gap = distance - radii;
        double along = a.radius() + gap / 2;
        out.add(centreAX + out.normalX * along, centreAY + out.normalY * along, gap, 0);
        return out.count;
    }
}
