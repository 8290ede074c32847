/**
 * Kernels that turn declared effects into accelerations, one class per effect. A steady force,
 * which is constant during a step, is added to the columns of accelerations. A force that varies
 * along the path is evaluated at instants of the path.
 */
package rigibo.backend.force;
