/**
 * Detects which shapes are inside sensors, after a step has moved all bodies. It moves and wakes no
 * body. Metres, seconds, radians.
 */
package rigibo.backend.sense;
