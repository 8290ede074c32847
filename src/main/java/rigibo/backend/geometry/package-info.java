/**
 * Shapes and the values that follow from them alone: bounds, mass, inertia, centroid; also exact
 * arithmetic of angles. Pure values in metres, radians and kilograms; knows nothing of bodies,
 * motion or time.
 */
package rigibo.backend.geometry;
