/**
 * The laws of the engine, held by hundreds of random scenes each. Sees the engine's public face
 * only. A failure names its seed and the fewest bodies found that still break the law, as code. SI
 * units throughout.
 */
package rigibo.backend.law;
