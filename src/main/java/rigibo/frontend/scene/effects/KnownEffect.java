package rigibo.frontend.scene.effects;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;

import java.util.List;
import java.util.Optional;

/**
 * Every kind of effect in the order of the bar, with words for scenes that have none of their own.
 * Offered everywhere are those that do something wherever bodies are; the others, whose numbers are
 * the materials' or the place's, only where a scene has them.
 */
enum KnownEffect {
    GRAVITY(new Gravity(0, -9.81), "everything falls"),
    CONTACTS(new Contacts(), "bodies lie on each other instead of passing through"),
    ROTATION(new Rotation(), "bodies turn and tip over"),
    FRICTION(new Friction(), "surfaces hold each other, by a share of the load"),
    RESTITUTION(new Restitution(), "what hits bounces, as elastic as it is"),
    ROLLING_RESISTANCE(RollingResistance.class, "what rolls slows down"),
    SURFACE_SPEED(SurfaceSpeed.class, "running surfaces carry what lies on them"),
    DRAG(Drag.class, "motion dies away, as in syrup"),
    BUOYANCY(Buoyancy.class, "water lifts what is in it"),
    CENTRAL_FORCE(CentralForce.class, "everything is pulled to one point"),
    FIELD(Field.class, "a force of the scene's own acts everywhere"),
    THRUST(Thrust.class, "what is driven is pushed and turned"),
    CONTINUOUS_IMPACTS(new ContinuousImpacts(), "what is fast cannot pass through a wall"),
    SLEEP(new Sleep(), "what rests is not computed until it is disturbed"),
    /** Air at sea level round discs. */
    AIR_DRAG(new AirDrag(1.2, 1.1), "the air slows what is fast"),
    WIND(new Wind(10, 0), "the air blows to the right");

    private final Class<? extends Effect> kind;
    private final Optional<Effect> offer;
    private final String words;

    KnownEffect(Effect offer, String words) {
        this(offer.getClass(), Optional.of(offer), words);
    }

    KnownEffect(Class<? extends Effect> kind, String words) {
        this(kind, Optional.empty(), words);
    }

    KnownEffect(Class<? extends Effect> kind, Optional<Effect> offer, String words) {
        this.kind = kind;
        this.offer = offer;
        this.words = words;
    }

    /**
     * What a scene shows of this kind: what it calls for, has words for, or everywhere is offered;
     * otherwise nothing.
     *
     * @param calledFor what the scene calls for
     * @param reasons the scene's own words
     */
    Optional<EffectReason> in(Effects calledFor, List<EffectReason> reasons) {
        Optional<EffectReason> own =
                reasons.stream().filter(reason -> kind.isInstance(reason.effect())).findFirst();
        Optional<Effect> effect = calledFor.find(kind).map(Effect.class::cast);
        return effect.or(() -> own.map(EffectReason::effect))
                .or(() -> offer)
                .map(shown -> new EffectReason(shown, own.map(EffectReason::words).orElse(words)));
    }
}
