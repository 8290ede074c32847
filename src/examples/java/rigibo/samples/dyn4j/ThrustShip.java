package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** A rocket of three parts balances on its jet: a force that acts. */
public final class ThrustShip implements Exhibit {
    private RigidBody ship;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        Compound rocket =
                Compound.of(
                        Part.of(Polygon.box(0.5, 1.4)),
                        Part.of(Polygon.hull(-0.25, 0.7, 0.25, 0.7, 0, 1.2)).at(0, 0.87),
                        Part.of(Polygon.box(1, 0.3)).at(0, -0.55));
        ship = pool.add(BodyDefinition.dynamic(rocket).at(-0.5, 1));
    }

    /** Holds a height and an upright pose by force and torque, as a pilot would. */
    @Override
    public void beforeStep(Pool pool) {
        double wanted = 4 + 1.5 * Angle.sin(pool.time());
        double lift = ship.mass() * (9.81 + 3 * (wanted - ship.y()) - 3 * ship.velocityY());
        double up = Math.max(0, lift);
        double lean = -ship.angle();
        ship.applyForce(
                -up * Angle.sin(ship.angle()), up * Angle.cos(ship.angle()), ship.x(), ship.y());
        ship.applyTorque(ship.inertia() * (20 * lean - 6 * ship.angularVelocity()));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        double x = ship.worldX(0, -0.9);
        double y = ship.worldY(0, -0.9);
        sketch.line(x, y, ship.worldX(0, -1.5), ship.worldY(0, -1.5), Sketch.Tone.BAD);
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new Thrust());
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}
