package rigibo.frontend.scene.effects;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.Wind;
import rigibo.frontend.scene.Words;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * A kind of effect in the bar, with general words for scenes without their own. Effects that act on
 * any bodies are offered everywhere; the others, whose parameters belong to materials or places,
 * only in scenes that have them.
 */
record KnownEffect(Effect.Kind kind) {

    /** Air comes last: it is offered everywhere, and few scenes call for it. */
    private static final Set<Effect.Kind> LAST = EnumSet.of(Effect.Kind.AIR_DRAG, Effect.Kind.WIND);

    /** Every kind in the order of the bar. */
    static List<KnownEffect> all() {
        return Stream.concat(EnumSet.complementOf(EnumSet.copyOf(LAST)).stream(), LAST.stream())
                .map(KnownEffect::new)
                .toList();
    }

    /** The effect that is offered where a scene neither has one nor words for it. */
    private Optional<Effect> offer() {
        return switch (kind) {
            case GRAVITY -> Optional.of(new Gravity(0, -9.81));
            case CONTACTS -> Optional.of(new Contacts());
            case ROTATION -> Optional.of(new Rotation());
            case FRICTION -> Optional.of(new Friction());
            case RESTITUTION -> Optional.of(new Restitution());
            case CONTINUOUS_IMPACTS -> Optional.of(new ContinuousImpacts());
            case SLEEP -> Optional.of(new Sleep());
            // At sea level round discs.
            case AIR_DRAG -> Optional.of(new AirDrag(1.2, 1.1));
            case WIND -> Optional.of(new Wind(10, 0));
            case ROLLING_RESISTANCE, SURFACE_SPEED, DRAG, THRUST, JOINTS, SENSORS ->
                    Optional.empty();
            case BUOYANCY, CENTRAL_FORCE, FAN, MAGNET, FIELD -> Optional.empty();
        };
    }

    /**
     * The effect of this kind that a scene shows: one that it calls for, has words for, or that is
     * offered everywhere. Otherwise empty.
     *
     * @param calledFor what the scene calls for
     * @param reasons the scene's own words
     * @param words the player's
     */
    Optional<EffectReason> in(Effects calledFor, List<EffectReason> reasons, Words words) {
        Optional<EffectReason> own =
                reasons.stream().filter(reason -> isOf(reason.effect())).findFirst();
        Optional<Effect> effect = calledFor.all().stream().filter(this::isOf).findFirst();
        return effect.or(() -> own.map(EffectReason::effect))
                .or(this::offer)
                .map(
                        shown ->
                                new EffectReason(
                                        shown,
                                        own.map(EffectReason::words)
                                                .orElse(general(shown, words))));
    }

    private boolean isOf(Effect effect) {
        return effect.kind() == kind;
    }

    /** What an effect does in any scene. */
    private static String general(Effect effect, Words words) {
        return words.of("effect." + effect.title() + ".words");
    }
}
