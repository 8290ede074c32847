/** The stages one step consists of, compiled from the declared effects and the accuracy. */
package rigibo.backend.step;
