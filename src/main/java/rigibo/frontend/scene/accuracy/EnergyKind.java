package rigibo.frontend.scene.accuracy;

import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.MotorJoint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Restitution;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.JointMotor;

import java.util.stream.Stream;

/**
 * How the energy of a scene may change under its declared effects, and so which changes are errors.
 */
public enum EnergyKind {
    /** Nothing can take or give any: every change is drift. */
    CONSERVED,
    /** Some is lost by design: a fall tells nothing, a rise is drift. */
    LOSING,
    /** Work is done from outside, or a force acts whose potential is not counted. */
    WORKED;

    /** The present kind of a pool. */
    public static EnergyKind of(Pool pool) {
        Effects effects = pool.effects();
        if (declaresAny(effects, Effect.Energy.GIVEN) || hasDriven(pool) || hasWorking(pool)) {
            return WORKED;
        }
        return declaresAny(effects, Effect.Energy.TAKEN) || losesInImpacts(pool) || hasBrake(pool)
                ? LOSING
                : CONSERVED;
    }

    private static boolean declaresAny(Effects effects, Effect.Energy energy) {
        return effects.all().stream().anyMatch(effect -> effect.kind().energy() == energy);
    }

    private static boolean hasDriven(Pool pool) {
        return pool.bodies().stream().anyMatch(body -> body.type() == BodyType.KINEMATIC);
    }

    /** A motor does work, unless it brakes; what a spring stores is not counted. */
    private static boolean hasWorking(Pool pool) {
        return definitions(pool)
                .anyMatch(
                        joint ->
                                joint.settings().spring().isThere()
                                        || drives(joint.settings().motor())
                                        || joint instanceof MotorJoint wanted && drives(wanted));
    }

    /** A motor that is to stand still. */
    private static boolean hasBrake(Pool pool) {
        return definitions(pool)
                .anyMatch(
                        joint -> joint.settings().motor().drives() || joint instanceof MotorJoint);
    }

    private static Stream<JointDefinition> definitions(Pool pool) {
        return pool.joints().stream().map(Joint::definition);
    }

    private static boolean drives(JointMotor motor) {
        return motor.drives() && motor.speed() != 0;
    }

    private static boolean drives(MotorJoint wanted) {
        return wanted.velocityX() != 0 || wanted.velocityY() != 0 || wanted.angularVelocity() != 0;
    }

    /** Of every pair that meets one is dynamic, and the greater of the two elasticities counts. */
    private static boolean losesInImpacts(Pool pool) {
        Effects effects = pool.effects();
        return effects.declares(Contacts.class)
                && (!effects.declares(Restitution.class)
                        || pool.bodies().stream().anyMatch(EnergyKind::isInelastic));
    }

    private static boolean isInelastic(RigidBody body) {
        return body.type() == BodyType.DYNAMIC && body.material().elasticity() < 1;
    }
}
