package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Restitution;
import rigibo.backend.setup.BodyType;

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
        if (declaresAny(effects, Effect.Energy.GIVEN) || hasDriven(pool)) {
            return WORKED;
        }
        return declaresAny(effects, Effect.Energy.TAKEN) || losesInImpacts(pool)
                ? LOSING
                : CONSERVED;
    }

    private static boolean declaresAny(Effects effects, Effect.Energy energy) {
        return effects.all().stream().anyMatch(effect -> effect.kind().energy() == energy);
    }

    private static boolean hasDriven(Pool pool) {
        return pool.bodies().stream().anyMatch(body -> body.type() == BodyType.KINEMATIC);
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
