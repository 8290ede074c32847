/** Repeatable random draws, and numbers worth trying. This room knows nothing of the project. */
package rigibo.fuzz.chance;
