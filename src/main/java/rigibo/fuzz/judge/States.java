package rigibo.fuzz.judge;

import static rigibo.fuzz.judge.LawBroken.unless;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;

/** The laws of a pool between any two steps. */
final class States {

    private static final String FINITE = "every state is finite";

    private States() {}

    static void requireSound(Pool pool) {
        for (RigidBody body : pool.bodies()) {
            requireSound(body);
        }
        requireFinite("Pool.time", pool.time());
    }

    private static void requireSound(RigidBody body) {
        requireFinite(body.name() + ".x", body.x());
        requireFinite(body.name() + ".y", body.y());
        requireFinite(body.name() + ".angle", body.angle());
        requireFinite(body.name() + ".velocityX", body.velocityX());
        requireFinite(body.name() + ".velocityY", body.velocityY());
        requireFinite(body.name() + ".angularVelocity", body.angularVelocity());
        unless(body.isAlive(), "what is listed is alive", "%s", body);
        boolean moves =
                body.velocityX() != 0 || body.velocityY() != 0 || body.angularVelocity() != 0;
        unless(
                body.type() != BodyType.STATIC || !moves,
                "what is static does not move",
                "%s has a velocity",
                body);
    }

    private static void requireFinite(String what, double number) {
        unless(Double.isFinite(number), FINITE, "%s is %s", what, number);
    }
}
