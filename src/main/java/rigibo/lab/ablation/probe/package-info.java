/**
 * What a Java process of its own runs and measures, against an engine with or without the classes
 * of undeclared effects. It stands on the engine and on {@code lab.child} alone, which fit into one
 * small archive.
 */
package rigibo.lab.ablation.probe;
