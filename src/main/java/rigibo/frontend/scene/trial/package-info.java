/**
 * Experiments on copies of a running scene, on a thread of their own and of the lowest priority.
 * What is measured, and what it means, is their owners' business: the effects bar asks what effects
 * cost, the accuracy bar what accuracy costs and brings.
 */
package rigibo.frontend.scene.trial;
