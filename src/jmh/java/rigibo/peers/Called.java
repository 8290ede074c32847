package rigibo.peers;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Wind;
import rigibo.backend.setup.BodyDefinition;

import java.util.List;

/**
 * The effects of a scene for engines that always simulate most of them: an undeclared effect
 * becomes a coefficient of 0.
 */
public final class Called {

    private static final List<Class<? extends Effect>> MISSING =
            List.of(Wind.class, Buoyancy.class, SurfaceSpeed.class, RollingResistance.class);

    private final Effects effects;
    private final Gravity gravity;

    /**
     * Reads the effects of a scene.
     *
     * @throws UnsupportedOperationException naming an effect that no peer has
     */
    public Called(Effects effects) {
        for (Effect effect : effects.all()) {
            if (MISSING.contains(effect.getClass())) {
                throw new UnsupportedOperationException(effect.getClass().getSimpleName());
            }
        }
        this.effects = effects;
        gravity = effects.find(Gravity.class).orElse(new Gravity(0, 0));
    }

    /** Gravity to the right, m/s². */
    public double gravityX() {
        return gravity.x();
    }

    /** Gravity upwards, m/s². */
    public double gravityY() {
        return gravity.y();
    }

    /** Whether bodies collide; otherwise they need no outline. */
    public boolean hasContacts() {
        return effects.declares(Contacts.class);
    }

    /** Whether bodies turn. */
    public boolean hasRotation() {
        return effects.declares(Rotation.class);
    }

    /**
     * Whether impacts are searched for within the step. Peers do so by default between moving and
     * fixed bodies. Their manuals reserve the flag of a bullet, which includes moving pairs, for
     * few bodies: with all flagged, Box2D's stack of ten boxes falls in 2 s.
     */
    public boolean hasContinuousImpacts() {
        return effects.declares(ContinuousImpacts.class);
    }

    /** Whether bodies fall asleep; the engine decides when. */
    public boolean hasSleep() {
        return effects.declares(Sleep.class);
    }

    /** Coulomb's μ of a body. */
    public double friction(BodyDefinition body) {
        return effects.declares(Friction.class) ? body.material().friction() : 0;
    }

    /** Elasticity of a body. */
    public double elasticity(BodyDefinition body) {
        return effects.declares(Restitution.class) ? body.material().elasticity() : 0;
    }

    /** Linear damping of a body, 1/s. */
    public double damping(BodyDefinition body) {
        return effects.declares(Drag.class) ? body.material().drag() : 0;
    }
}
