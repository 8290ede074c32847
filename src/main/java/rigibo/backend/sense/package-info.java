/**
 * Who is inside of a sensor, asked once all bodies are where the step leaves them. It moves nothing
 * and wakes nobody. m, s, rad.
 */
package rigibo.backend.sense;
