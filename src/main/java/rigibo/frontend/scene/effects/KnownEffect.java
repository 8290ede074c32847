package rigibo.frontend.scene.effects;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.Optional;

/**
 * Every kind of effect in the order of the bar, with general words for scenes without their own.
 * Effects that act on any bodies are offered everywhere; the others, whose parameters belong to
 * materials or places, only in scenes that have them.
 */
enum KnownEffect {
    GRAVITY(new Gravity(0, -9.81)),
    CONTACTS(new Contacts()),
    ROTATION(new Rotation()),
    FRICTION(new Friction()),
    RESTITUTION(new Restitution()),
    ROLLING_RESISTANCE(RollingResistance.class),
    SURFACE_SPEED(SurfaceSpeed.class),
    DRAG(Drag.class),
    BUOYANCY(Buoyancy.class),
    CENTRAL_FORCE(CentralForce.class),
    FAN(Fan.class),
    MAGNET(Magnet.class),
    FIELD(Field.class),
    THRUST(Thrust.class),
    JOINTS(Joints.class),
    SENSORS(Sensors.class),
    CONTINUOUS_IMPACTS(new ContinuousImpacts()),
    SLEEP(new Sleep()),
    /** Air at sea level round discs. */
    AIR_DRAG(new AirDrag(1.2, 1.1)),
    WIND(new Wind(10, 0));

    private final Class<? extends Effect> kind;
    private final Optional<Effect> offer;

    KnownEffect(Effect offer) {
        this(offer.getClass(), Optional.of(offer));
    }

    KnownEffect(Class<? extends Effect> kind) {
        this(kind, Optional.empty());
    }

    KnownEffect(Class<? extends Effect> kind, Optional<Effect> offer) {
        this.kind = kind;
        this.offer = offer;
    }

    /**
     * What a scene shows of this kind: what it calls for, has words for, or everywhere is offered;
     * otherwise nothing.
     *
     * @param calledFor what the scene calls for
     * @param reasons the scene's own words
     * @param words the player's
     */
    Optional<EffectReason> in(Effects calledFor, List<EffectReason> reasons, Words words) {
        Optional<EffectReason> own =
                reasons.stream().filter(reason -> kind.isInstance(reason.effect())).findFirst();
        Optional<Effect> effect = calledFor.find(kind).map(Effect.class::cast);
        return effect.or(() -> own.map(EffectReason::effect))
                .or(() -> offer)
                .map(
                        shown ->
                                new EffectReason(
                                        shown,
                                        own.map(EffectReason::words)
                                                .orElse(general(shown, words))));
    }

    /** What an effect does wherever bodies are. */
    private static String general(Effect effect, Words words) {
        return words.of("effect." + effect.title() + ".words");
    }
}
