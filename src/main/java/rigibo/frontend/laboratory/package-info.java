/**
 * The laboratory: the same scene at two accuracies side by side, what their steps take, what they
 * do to energy, and how far they grow apart.
 */
package rigibo.frontend.laboratory;
