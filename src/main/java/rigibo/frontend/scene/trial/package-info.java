/**
 * Experiments on copies of a running scene, on a thread of their own with the lowest priority.
 * Their owners decide what is measured and what it means: the effects bar measures what effects
 * cost, the accuracy bar what accuracy costs and brings.
 */
package rigibo.frontend.scene.trial;
