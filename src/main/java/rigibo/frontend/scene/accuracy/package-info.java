/**
 * What accuracy costs and what it brings, in the scene itself: the dial of four presets, a badge
 * with the time of a step, its price and its error, and the book of the energy. A scene gives its
 * pool and two turns round each step, and draws an {@link
 * rigibo.frontend.scene.accuracy.AccuracyBar} and an {@link
 * rigibo.frontend.scene.accuracy.EnergyPlate}.
 *
 * <p>Price and error are measured on copies of the pool; the pool itself is only looked at. Times
 * are ns inside, energies J, distances m.
 */
package rigibo.frontend.scene.accuracy;
