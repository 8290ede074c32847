/**
 * Experiments on copies of a running scene, on a thread of their own with the lowest priority.
 * Their owners decide what to measure: the effects bar measures the cost of effects, the accuracy
 * bar the cost and the error of each accuracy.
 */
package rigibo.frontend.scene.trial;
