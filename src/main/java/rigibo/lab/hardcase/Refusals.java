package rigibo.lab.hardcase;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;

/** Input that no pool may accept, each with the field that the refusal must name. */
final class Refusals {

    private static final double NAN = Double.NaN;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** The attempts on a pool and a body in it, by the field at fault. */
    private final Map<String, Consumer<RigidBody>> attempts = new LinkedHashMap<>();

    private final Pool pool;

    Refusals(Pool pool) {
        this.pool = pool;
        shapes();
        materials();
        definitions();
        effectsAndAccuracy();
        verbs();
    }

    Map<String, Consumer<RigidBody>> attempts() {
        return attempts;
    }

    private void shapes() {
        attempts.put("radius 0", b -> new Circle(0));
        attempts.put("radius negative", b -> new Circle(-1));
        attempts.put("radius NaN", b -> new Circle(NAN));
        attempts.put("radius infinite", b -> new Circle(INFINITE));
        attempts.put("radius whose inertia overflows", b -> new Circle(1e100));
        attempts.put("width 0", b -> Polygon.box(0, 1));
        attempts.put("height NaN", b -> Polygon.box(1, NAN));
        attempts.put("corner NaN", b -> Polygon.of(0, 0, 1, 0, NAN, 1));
        attempts.put("corner infinite", b -> Polygon.of(0, 0, 1, 0, INFINITE, 1));
        attempts.put("corner repeated", b -> Polygon.of(0, 0, 1, 0, 1, 0, 0, 1));
        attempts.put("corner collinear", b -> Polygon.of(0, 0, 1, 0, 2, 0, 0, 1));
        attempts.put("corner reflex", b -> Polygon.of(0, 0, 2, 0, 0.5, 0.5, 0, 2));
        attempts.put("corners clockwise", b -> Polygon.of(0, 0, 0, 1, 1, 0));
        attempts.put("corners fewer than 3", b -> Polygon.of(0, 0, 1, 0));
        attempts.put("numbers odd", b -> Polygon.of(0, 0, 1, 0, 1));
        attempts.put("corners of a star", b -> Polygon.of(star()));
        attempts.put("corners regular 2", b -> Polygon.regular(2, 1));
        attempts.put("corners regular 257", b -> Polygon.regular(257, 1));
    }

    private static double[] star() {
        double[] xy = new double[10];
        for (int i = 0; i < 5; i++) {
            xy[2 * i] = Math.cos(4 * Math.PI * i / 5);
            xy[2 * i + 1] = Math.sin(4 * Math.PI * i / 5);
        }
        return xy;
    }

    private void materials() {
        attempts.put("density 0", b -> new Material(0, 0.5, 0));
        attempts.put("density NaN", b -> new Material(NAN, 0.5, 0));
        attempts.put("friction negative", b -> new Material(1, -0.1, 0));
        attempts.put("friction NaN", b -> new Material(1, NAN, 0));
        attempts.put("elasticity above 1", b -> new Material(1, 0.5, 1.01));
        attempts.put("elasticity NaN", b -> new Material(1, 0.5, NAN));
        attempts.put("rollingResistance negative", b -> Material.DEFAULT.rollingResistance(-1));
        attempts.put("drag infinite", b -> Material.DEFAULT.drag(INFINITE));
    }

    private void definitions() {
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1));
        BodyDefinition floor = BodyDefinition.fixed(Polygon.box(1, 1));
        attempts.put("shape absent", b -> BodyDefinition.dynamic(null));
        attempts.put("material absent", b -> box.material(null));
        attempts.put("x NaN", b -> box.at(NAN, 0));
        attempts.put("y infinite", b -> box.at(0, INFINITE));
        attempts.put("angle NaN", b -> box.angle(NAN));
        attempts.put("velocityX infinite", b -> box.velocity(INFINITE, 0));
        attempts.put("velocityY NaN", b -> box.velocity(0, NAN));
        attempts.put("spin NaN", b -> box.spin(NAN));
        attempts.put("mass 0", b -> box.mass(0));
        attempts.put("mass infinite", b -> box.mass(INFINITE));
        attempts.put("inertia NaN", b -> box.inertia(NAN));
        attempts.put("gravityScale NaN", b -> box.gravityScale(NAN));
        attempts.put("velocity of a static body", b -> floor.velocity(1, 0));
    }

    private void effectsAndAccuracy() {
        attempts.put("Gravity NaN", b -> new Gravity(0, NAN));
        attempts.put("Sleep of 0 s", b -> new Sleep(0, 1e-4));
        attempts.put("Friction without Contacts", b -> Effects.of(new Friction()));
        attempts.put(
                "RollingResistance without Rotation",
                b -> Effects.of(new Contacts(), new RollingResistance()));
        attempts.put("Contacts twice", b -> Effects.of(new Contacts(), new Contacts()));
        attempts.put("substeps 0", b -> Accuracy.GAME.withSubsteps(0));
        attempts.put("substeps 65", b -> Accuracy.GAME.withSubsteps(65));
        attempts.put("impactTolerance NaN", b -> Accuracy.GAME.withImpactTolerance(NAN));
    }

    private void verbs() {
        attempts.put("dt 0", b -> pool.step(0));
        attempts.put("dt negative", b -> pool.step(-1));
        attempts.put("dt NaN", b -> pool.step(NAN));
        attempts.put("dt beyond 10 s", b -> pool.step(10.1));
        attempts.put("x NaN in moveTo", b -> b.moveTo(NAN, 0, 0));
        attempts.put("velocity infinite", b -> b.velocity(INFINITE, 0));
        attempts.put("spin infinite", b -> b.spin(INFINITE));
        attempts.put("applyForce fx NaN", b -> b.applyForce(NAN, 0, 0, 0));
        attempts.put("applyForce px infinite", b -> b.applyForce(0, 0, INFINITE, 0));
        attempts.put("applyTorque NaN", b -> b.applyTorque(NAN));
        attempts.put("applyImpulse jy NaN", b -> b.applyImpulse(0, NAN, 0, 0));
        attempts.put("definition absent", b -> pool.add(null));
        attempts.put("x NaN in bodyAt", b -> pool.bodyAt(NAN, 0));
        attempts.put("fromX NaN", b -> pool.rayCast(NAN, 0, 1, 1));
        attempts.put("type absent", b -> b.type(null));
    }
}
