package rigibo.examples;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** Five balls on hinged rods: what swings in on one side swings out on the other. */
public final class Cradle implements Exhibit {

    static final double ROD = 3; // m
    static final double RADIUS = 0.4; // m
    static final double LIFT = 0.8; // rad

    final List<RigidBody> balls = new ArrayList<>();

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody beam = pool.add(BodyDefinition.fixed(Polygon.box(6, 0.3)).at(0, 5.2).group(1));
        for (int i = 0; i < 5; i++) {
            double pivot = 2 * RADIUS * (i - 2);
            double angle = i == 0 ? -LIFT : 0;
            RigidBody ball =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(RADIUS))
                                    .at(pivot + ROD * Angle.sin(angle), 5 - ROD * Angle.cos(angle))
                                    .material(new Material(1000, 0, 1)));
            balls.add(ball);
            pool.join(DistanceJoint.rod(beam, pivot, 5, ball, ball.x(), ball.y()));
        }
    }

    /** How high a ball is over where it hangs, m. */
    double rise(int ball) {
        return balls.get(ball).y() - (5 - ROD);
    }

    @Override
    public View view() {
        return new View(0, 3, 8.8);
    }
}
