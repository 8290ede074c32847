package rigibo.backend;

import rigibo.backend.collision.distance.PointAndRay;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Found;

/** Applies the impulses of an {@link Explosion} to the bodies it reaches. */
final class Blast {

    private final Bodies bodies;
    private final PoolQueries queries;
    private final BodyEditor editor;
    private final PointAndRay pointAndRay = new PointAndRay();
    private final Pose pose = new Pose();

    /** Bodies that were pushed, listed once for each of their shapes. */
    private final Found struck = new Found();

    Blast(Bodies bodies, PoolQueries queries, BodyEditor editor) {
        this.bodies = bodies;
        this.queries = queries;
        this.editor = editor;
    }

    void of(Explosion explosion) {
        double reach = explosion.radius() + explosion.falloff();
        double x = explosion.x();
        double y = explosion.y();
        Found found = queries.near(new Aabb(x - reach, y - reach, x + reach, y + reach));
        VelocitiesKept kept = new VelocitiesKept(bodies, found);
        try {
            for (int i = 0; i < found.count; i++) {
                int slot = found.numbers[i];
                if (bodies.isDynamic(slot) && queries.meets(slot, explosion.filter())) {
                    strike(explosion, slot);
                }
            }
        } catch (IllegalArgumentException tooFast) {
            kept.giveBack();
            throw tooFast;
        }
        for (int i = 0; i < struck.count; i++) {
            editor.motion.wake(struck.numbers[i]);
        }
    }

    private void strike(Explosion explosion, int slot) {
        int body = bodies.bodyOf(slot);
        Outline outline = bodies.outline[slot];
        pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
        double distance = pointAndRay.nearest(outline, pose, explosion.x(), explosion.y());
        double share = explosion.shareAt(distance);
        // A shape that contains the centre of the explosion is pushed at its centre of mass.
        double atX = distance > 0 ? pointAndRay.pointX : pose.x;
        double atY = distance > 0 ? pointAndRay.pointY : pose.y;
        double dx = atX - explosion.x();
        double dy = atY - explosion.y();
        double length = Math.sqrt(dx * dx + dy * dy);
        if (share == 0 || length == 0) {
            return;
        }
        double nx = dx / length;
        double ny = dy / length;
        double impulse = share * explosion.impulsePerMetre() * width(outline, -ny, nx);
        editor.motion.push(body, impulse * nx, impulse * ny, atX, atY);
        struck.add(body);
    }

    /** Extent in m of an outline along a unit vector in the world frame. */
    private double width(Outline outline, double x, double y) {
        double localX = pose.cos * x + pose.sin * y;
        double localY = pose.cos * y - pose.sin * x;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < outline.corners(); i++) {
            double along = localX * outline.cornerX(i) + localY * outline.cornerY(i);
            least = Math.min(least, along);
            most = Math.max(most, along);
        }
        return most - least + 2 * outline.radius();
    }

    /** Velocities before the explosion: they are restored if one body would become too fast. */
    private static final class VelocitiesKept {

        private final Bodies bodies;
        private final Found shapes;
        private final double[] velocities;

        VelocitiesKept(Bodies bodies, Found shapes) {
            this.bodies = bodies;
            this.shapes = shapes;
            velocities = new double[3 * shapes.count];
            for (int i = 0; i < shapes.count; i++) {
                int body = bodies.bodyOf(shapes.numbers[i]);
                velocities[3 * i] = bodies.velocityX[body];
                velocities[3 * i + 1] = bodies.velocityY[body];
                velocities[3 * i + 2] = bodies.spinOf(body);
            }
        }

        void giveBack() {
            for (int i = 0; i < shapes.count; i++) {
                int body = bodies.bodyOf(shapes.numbers[i]);
                bodies.velocityX[body] = velocities[3 * i];
                bodies.velocityY[body] = velocities[3 * i + 1];
                if (bodies.turns()) {
                    bodies.spin[body] = velocities[3 * i + 2];
                }
            }
        }
    }
}
