/**
 * Cost and benefit of accuracy, shown in the scene itself: the dial of four presets, a badge with
 * the time of a step, its price and its error, and the energy balance. A scene provides its pool,
 * calls twice around each step, and draws an {@link rigibo.frontend.scene.accuracy.AccuracyBar} and
 * an {@link rigibo.frontend.scene.accuracy.EnergyPlate}.
 *
 * <p>Price and error are measured on copies; the pool itself is only read. Times are in ns
 * internally, energies in J, distances in m.
 */
package rigibo.frontend.scene.accuracy;
