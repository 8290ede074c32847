/** Benchmarks of the engine's stages, for those who change one of them. */
package rigibo.benchmarks;
