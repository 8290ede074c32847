package rigibo.samples.box2d;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Bodies on rods, on ropes and on springs between two lengths. */
public final class DistanceJoints implements Exhibit {

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody beam = pool.add(BodyDefinition.fixed(Polygon.box(8, 0.3)).at(0, 6));
        for (int i = 0; i < 3; i++) {
            double x = 2.4 * (i - 1);
            RigidBody before = beam;
            double top = 5.85;
            for (int k = 0; k < 3; k++) {
                RigidBody ball =
                        pool.add(
                                BodyDefinition.dynamic(new Circle(0.25))
                                        .at(x + 0.3 * (k + 1), top - 1.1)
                                        .mass(5));
                pool.join(joint(i, before, k == 0 ? x : before.x(), top, ball));
                top = ball.y();
                before = ball;
            }
        }
    }

    private static JointDefinition joint(
            int kind, RigidBody above, double x, double y, RigidBody ball) {
        DistanceJoint rod = DistanceJoint.rod(above, x, y, ball, ball.x(), ball.y());
        return switch (kind) {
            case 0 -> rod;
            case 1 -> DistanceJoint.rope(above, x, y, ball, ball.x(), ball.y(), 1.5);
            default -> rod.limits(0.6, 2).spring(2, 0.1);
        };
    }

    @Override
    public View view() {
        return new View(0, 3.6, 8);
    }
}
