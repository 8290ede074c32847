package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;

import java.util.Optional;

/**
 * One effect of a set switched: off where it is declared, on where it is not.
 *
 * @param effects the set it makes; none where another effect needs this one, or this one another
 * @param refusal the engine's words for that; empty otherwise
 */
record Switching(Optional<Effects> effects, String refusal) {

    static Switching of(Effects now, Effect effect) {
        Class<? extends Effect> kind = effect.getClass();
        try {
            Effects next = now.declares(kind) ? now.without(kind) : now.with(effect);
            return new Switching(Optional.of(next), "");
        } catch (IllegalArgumentException needed) {
            return new Switching(Optional.empty(), needed.getMessage());
        }
    }
}
