/**
 * That what is not declared costs nothing, measured: scenes run in Java processes of their own
 * against the engine as it is and against one from which the classes of all undeclared effects are
 * taken out; what a declared effect costs by how many use it; what a scene would save without it.
 */
package rigibo.lab.ablation;
