/**
 * The effects a scene may declare. Records only: what an effect does sits in a stage or a kernel of
 * its own, which is loaded only where the effect is declared.
 */
package rigibo.backend.effect;
