/**
 * The cost of effects, measured. Undeclared ones: scenes run in Java processes of their own,
 * against the whole engine and against one without their classes. Declared ones: by the number of
 * bodies that use them, and by what a scene would save without them.
 */
package rigibo.lab.ablation;
