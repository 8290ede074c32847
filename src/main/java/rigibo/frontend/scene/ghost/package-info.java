/**
 * Two pools of the same bodies beside each other: how far they are apart, whether that has become
 * chaos, and the ghost, which is a scene's pool at another accuracy. Metres, seconds, ns.
 */
package rigibo.frontend.scene.ghost;
