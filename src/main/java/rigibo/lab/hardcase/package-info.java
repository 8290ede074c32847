/**
 * The hard cases: scenes whose truth is known in closed form or as an invariant. A case states its
 * bodies, effects, horizon, truth, measures and limits per preset. It uses the public API of the
 * engine alone and measures it by instruments of its own. SI units.
 */
package rigibo.lab.hardcase;
