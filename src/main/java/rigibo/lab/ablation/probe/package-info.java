/**
 * What a Java process of its own runs and measures, against an engine with or without the classes
 * of undeclared effects. It stands on the engine alone, so that both fit into one small archive.
 */
package rigibo.lab.ablation.probe;
