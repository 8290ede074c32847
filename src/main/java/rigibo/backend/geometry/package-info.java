/**
 * Shapes and what follows from them alone: bounds, mass, inertia, centroid, exact arithmetic of
 * angles. Pure values in metres, radians and kilograms; knows nothing of bodies, motion or time.
 */
package rigibo.backend.geometry;
