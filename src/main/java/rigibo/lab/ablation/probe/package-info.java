/**
 * The code that each measuring process runs, against an engine with or without the classes of
 * undeclared effects. It uses the engine and {@code lab.child} alone, which fit into one small
 * archive.
 */
package rigibo.lab.ablation.probe;
