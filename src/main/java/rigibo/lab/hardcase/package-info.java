/**
 * The hard cases: scenes whose truth is known in closed form or as an invariant, each defined once.
 * A case knows its bodies, its effects, its horizon, its truth, its measures and their limits per
 * preset; it sees the engine's public face only and judges it by instruments of its own. SI units.
 */
package rigibo.lab.hardcase;
