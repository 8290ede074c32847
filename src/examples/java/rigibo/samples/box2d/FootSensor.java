package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.SensorEvent;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Sensors at its feet tell a hopper when it may hop again. */
public final class FootSensor implements Exhibit {
    private RigidBody hopper;

    @Override
    public void build(Pool pool) {

        pool.add(BodyDefinition.fixed(Chain.open(4, 3, 3.8, 0, 1, 0.3, -1, 0, -3.8, 0.4, -4, 3)));
        Compound body =
                Compound.of(
                        Part.of(new Capsule(0.4, 0.3)).angle(Math.PI / 2),
                        Part.of(Polygon.box(0.4, 0.2)).at(0, -0.75).sensor());
        hopper =
                pool.add(
                        BodyDefinition.dynamic(body)
                                .at(-2, 1.5)
                                .lockRotation()
                                .material(new Material(1, 0, 0)));
    }

    @Override
    public void beforeStep(Pool pool) {
        if (stands(pool) && hopper.velocityY() < 0.5) {
            double away =
                    hopper.x() > 2
                            ? -1.5
                            : hopper.x() < -2 ? 1.5 : Math.copySign(1.5, hopper.velocityX());
            hopper.velocity(away, 5);
        }
    }

    private boolean stands(Pool pool) {
        return pool.sensorEvents().stream()
                .anyMatch(
                        event ->
                                event.sensor() == hopper
                                        && event.phase() != SensorEvent.Phase.LEFT);
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.point(
                hopper.x(), hopper.y() - 0.75, stands(pool) ? Sketch.Tone.GOOD : Sketch.Tone.PLAIN);
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new Sensors());
    }

    @Override
    public View view() {
        return new View(0, 2, 9);
    }
}
