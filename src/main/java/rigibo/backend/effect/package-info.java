/**
 * The effects a scene can declare, as records without behaviour. The code of an effect is a stage
 * or a kernel in another package and is loaded only where the effect is declared.
 */
package rigibo.backend.effect;
