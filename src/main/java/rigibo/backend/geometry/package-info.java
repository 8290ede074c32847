/**
 * Shapes and the values that follow from them alone: bounds, mass, inertia, centroid; also the
 * elementary functions, whose bits are the same on every JVM and in every browser. Pure values in
 * metres, radians and kilograms; knows nothing of bodies, motion or time.
 */
package rigibo.backend.geometry;
