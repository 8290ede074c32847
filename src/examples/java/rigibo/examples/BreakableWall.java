package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Bricks held together by mortar of limited strength; a ball breaks joints that are overloaded. */
public final class BreakableWall implements Exhibit {

    static final double MOST = 9_000; // N
    private static final int COLUMNS = 4;
    private static final int ROWS = 7;

    RigidBody ball;

    /** How many bonds have broken so far. */
    int broken;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody ground = pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        RigidBody[][] bricks = new RigidBody[ROWS][COLUMNS];
        for (int row = 0; row < ROWS; row++) {
            for (int i = 0; i < COLUMNS; i++) {
                double x = 1 + 0.5 * i;
                double y = 0.2 + 0.4 * row;
                bricks[row][i] =
                        pool.add(
                                BodyDefinition.dynamic(Polygon.box(0.5, 0.4))
                                        .at(x, y)
                                        .material(new Material(100, 0.6, 0)));
                bond(pool, row > 0 ? bricks[row - 1][i] : ground, bricks[row][i], x, y - 0.2);
                if (i > 0) {
                    bond(pool, bricks[row][i - 1], bricks[row][i], x - 0.25, y);
                }
            }
        }
        ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.4))
                                .at(-5, 1)
                                .velocity(12, 3)
                                .material(new Material(500, 0.4, 0)));
    }

    private static void bond(Pool pool, RigidBody a, RigidBody b, double x, double y) {
        pool.join(WeldJoint.at(a, b, x, y).breaking(MOST, Double.POSITIVE_INFINITY));
    }

    @Override
    public void beforeStep(Pool pool) {
        broken += pool.brokenJoints().size();
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count("" + broken);
    }

    @Override
    public View view() {
        return new View(0, 2.2, 10);
    }
}
