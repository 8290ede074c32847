/**
 * The effects bar: which effects a scene simulates and why, what each of them costs, measured while
 * the scene runs, and a switch for each. A scene describes itself as {@link
 * rigibo.frontend.scene.effects.SceneEffects}, draws an {@link
 * rigibo.frontend.scene.effects.EffectsBar}, and passes it the pointer and one call per frame.
 *
 * <p>Costs are measured on copies of the pool, on a thread of their own; the game's pool only
 * provides snapshots. Times are in ns internally and shown in µs or ms.
 */
package rigibo.frontend.scene.effects;
