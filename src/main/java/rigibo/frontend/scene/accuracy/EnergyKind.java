package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.setup.BodyType;

import java.util.List;

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

    private static final List<Class<? extends Effect>> WORKING =
            List.of(
                    Thrust.class,
                    Field.class,
                    SurfaceSpeed.class,
                    Wind.class,
                    CentralForce.class,
                    Fan.class,
                    Magnet.class,
                    Buoyancy.class);

    /** Sleep belongs here: it takes the last of the motion. */
    private static final List<Class<? extends Effect>> TAKING =
            List.of(
                    Friction.class,
                    Drag.class,
                    AirDrag.class,
                    RollingResistance.class,
                    Sleep.class);

    /** The kind of a pool as it is now. */
    public static EnergyKind of(Pool pool) {
        Effects effects = pool.effects();
        if (declaresAny(effects, WORKING) || hasDriven(pool)) {
            return WORKED;
        }
        return declaresAny(effects, TAKING) || losesInImpacts(pool) ? LOSING : CONSERVED;
    }

    private static boolean declaresAny(Effects effects, List<Class<? extends Effect>> kinds) {
        return kinds.stream().anyMatch(effects::declares);
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
