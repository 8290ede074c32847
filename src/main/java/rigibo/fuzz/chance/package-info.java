/** Chance that a seed repeats, and the numbers worth trying. Knows nothing of the project. */
package rigibo.fuzz.chance;
