package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Shape;

/** Two shapes at two poses, and the manifold between them. */
public final class Meeting {

    final Shape a;
    final Pose poseA;
    final Shape b;
    final Pose poseB;
    public final Manifold manifold = new Manifold();

    public Meeting(Shape a, Pose poseA, Shape b, Pose poseB) {
        this.a = a;
        this.poseA = poseA;
        this.b = b;
        this.poseB = poseB;
    }

    public static Pose pose(double x, double y, double angle) {
        Pose pose = new Pose();
        pose.set(x, y, Angle.cos(angle), Angle.sin(angle));
        return pose;
    }

    /** Fills and returns the manifold, with points up to a gap of {@code reach} m. */
    public Manifold within(double reach) {
        new Collider().collide(a.outline(0), poseA, b.outline(0), poseB, reach, manifold);
        return manifold;
    }

    Meeting exchanged() {
        return new Meeting(b, poseB, a, poseA);
    }

    /** The smaller separation of the manifold's points, m. */
    public double gap() {
        return manifold.count == 1
                ? manifold.separation[0]
                : Math.min(manifold.separation[0], manifold.separation[1]);
    }
}
