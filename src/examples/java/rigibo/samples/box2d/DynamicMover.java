package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** A capsule walks over hills, through a swing door, and jumps up through shelves. */
public final class DynamicMover implements Exhibit {

    private static final double SPEED = 2; // m/s
    private static final double JUMP = 6.5; // m/s
    private static final double END = 5.5; // m, where it turns
    private static final Capsule BODY = new Capsule(0.3, 0.3);
    private static final Filter MOVER = Filter.ALL.category(2);
    private static final Filter WORLD = Filter.ALL.mask(1);

    private RigidBody mover;
    private int direction = 1;

    @Override
    public void build(Pool pool) {
        RigidBody hills =
                pool.add(
                        BodyDefinition.fixed(
                                Chain.open(
                                        7, 5, 6.8, 0.2, 5, 0, 3, 0.4, 1.5, 0, -1.5, 0, -3, 0.6, -5,
                                        0, -6.8, 0.3, -7, 5)));
        Material shelf = new Material(1000, 0.5, 0).oneWay(0, 1);
        pool.add(BodyDefinition.fixed(Polygon.box(2.4, 0.15)).at(3.6, 1.9).material(shelf));
        pool.add(BodyDefinition.fixed(Polygon.box(2.4, 0.15)).at(-3.6, 2).material(shelf));
        RigidBody door =
                pool.add(BodyDefinition.dynamic(Polygon.box(0.12, 1.8)).at(0, 1.1).mass(5));
        pool.join(RevoluteJoint.at(hills, door, 0, 2).motor(0, 2));
        mover =
                pool.add(
                        BodyDefinition.dynamic(BODY)
                                .at(-5, 1)
                                .angle(Math.PI / 2)
                                .material(new Material(100, 0, 0))
                                .filter(MOVER)
                                .lockRotation());
    }

    @Override
    public void beforeStep(Pool pool) {
        if (mover.x() * direction > END) {
            direction = -direction;
        }
        boolean isUnderAShelf = Math.abs(Math.abs(mover.x()) - 3.6) < 0.3;
        boolean jumps = isOnGround(pool) && isUnderAShelf && mover.y() < 1.5;
        mover.velocity(SPEED * direction, jumps ? JUMP : mover.velocityY());
    }

    private boolean isOnGround(Pool pool) {
        Placement at = new Placement(mover.x(), mover.y() + 0.01, mover.angle());
        return mover.velocityY() < 1 && pool.cast(BODY, at, 0, -0.1, WORLD).isPresent();
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        Sketch.Tone tone = isOnGround(pool) ? Sketch.Tone.GOOD : Sketch.Tone.PLAIN;
        sketch.point(mover.x(), mover.y() - 0.6, tone);
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public View view() {
        return new View(0, 2.5, 14);
    }
}
