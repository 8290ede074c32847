package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** A character that walks: it feels for the ground, jumps onto steps and turns at cliffs. */
public final class Walker implements Exhibit {

    static final double SPEED = 2; // m/s
    static final double JUMP = 5; // m/s
    private static final Filter WORLD = Filter.ALL.mask(1);
    private static final Capsule BODY = new Capsule(0.4, 0.3);

    RigidBody walker;
    int direction = 1;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(8, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(1.6, 0.8)).at(1.4, 0.4));
        pool.add(BodyDefinition.fixed(Polygon.box(1.2, 3)).at(-3.4, 1.5));
        walker =
                pool.add(
                        BodyDefinition.dynamic(BODY)
                                .at(-1.5, 0.7)
                                .angle(Math.PI / 2)
                                .material(new Material(80, 0, 0))
                                .filter(Filter.ALL.category(2))
                                .lockRotation());
    }

    @Override
    public void beforeStep(Pool pool) {
        boolean isBlocked = feels(pool, 0.35 * direction, 0);
        if (!isOnGround(pool)) {
            walker.velocity(SPEED * direction, walker.velocityY());
        } else if (isBlocked && !sees(pool, 1.3)) {
            walker.velocity(0, JUMP);
        } else {
            boolean isCliff = pool.rayCast(ahead(), walker.y(), ahead(), foot() - 0.9).isEmpty();
            direction = isBlocked || isCliff ? -direction : direction;
            walker.velocity(SPEED * direction, walker.velocityY());
        }
        walker.wake();
    }

    boolean isOnGround(Pool pool) {
        return walker.velocityY() < 0.5 && feels(pool, 0, -0.05);
    }

    /** Whether its own shape would meet something on a way. */
    private boolean feels(Pool pool, double dx, double dy) {
        // A hair above the ground, or the ground itself would be in the way.
        Placement at = new Placement(walker.x(), walker.y() + 0.01, walker.angle());
        return pool.cast(BODY, at, dx, dy, WORLD).isPresent();
    }

    /** Whether there is a wall ahead at a height over its feet, m. */
    private boolean sees(Pool pool, double height) {
        double y = foot() + height;
        return pool.rayCast(walker.x(), y, ahead() + 0.4 * direction, y, WORLD).isPresent();
    }

    private double ahead() {
        return walker.x() + 0.4 * direction;
    }

    private double foot() {
        return walker.y() - 0.7;
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.line(ahead(), walker.y(), ahead(), foot() - 0.9, Sketch.Tone.GOOD);
        double y = foot() + 1.3;
        sketch.line(walker.x(), y, ahead() + 0.4 * direction, y, Sketch.Tone.PLAIN);
    }

    @Override
    public View view() {
        return new View(0, 2, 9);
    }

    /** Prints where it walks, every second. */
    public static void main(String[] arguments) {
        Walker example = new Walker();
        Pool pool = example.open();
        for (int i = 0; i < 12; i++) {
            example.run(pool, 1);
            System.out.printf("%.0f s: %s%n", pool.time(), example.walker);
        }
    }
}
