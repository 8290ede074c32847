/** Kernels that turn declared effects into accelerations, one class per effect. */
package rigibo.backend.force;
