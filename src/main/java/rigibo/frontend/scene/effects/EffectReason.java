package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effect;

/**
 * The role of an effect in a scene. An effect that the scene does not need is an offer: a click
 * switches it on with these parameters.
 *
 * @param effect the effect, with the parameters for switching it on
 * @param words what it does in the scene, such as "crates hold each other in the stack"
 */
public record EffectReason(Effect effect, String words) {}
