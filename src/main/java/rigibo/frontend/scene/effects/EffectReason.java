package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effect;

/**
 * What an effect is to a scene. Of an effect that the scene does not call for it is an offer: a
 * click switches it on with these parameters.
 *
 * @param effect which, with the parameters a click switches it on with
 * @param words what it does there, as it does it: "crates hold each other in the stack"
 */
public record EffectReason(Effect effect, String words) {}
