/**
 * The laboratory: the same scene at two accuracies side by side, with the time of their steps,
 * their energy, and the distance between them.
 */
package rigibo.frontend.laboratory;
