/**
 * Kernels that turn declared effects into accelerations, one class per effect. Those that are the
 * same all along a step are added to columns; those that change along a body's way are asked for
 * instants of it.
 */
package rigibo.backend.force;
