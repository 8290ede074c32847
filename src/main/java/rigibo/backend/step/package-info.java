/** The stages of a step, compiled from the declared effects and the accuracy. */
package rigibo.backend.step;
