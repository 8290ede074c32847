/**
 * The effects bar: what a scene simulates and why, what each effect costs as measured while the
 * scene runs, and a switch for each. A scene describes itself as {@link
 * rigibo.frontend.scene.effects.SceneEffects}, draws an {@link
 * rigibo.frontend.scene.effects.EffectsBar}, and hands it the pointer and a turn per frame.
 *
 * <p>Costs are measured on copies of the pool, on a thread of their own: the game's pool is only
 * asked for a snapshot. Times are ns inside and µs or ms where they are shown.
 */
package rigibo.frontend.scene.effects;
