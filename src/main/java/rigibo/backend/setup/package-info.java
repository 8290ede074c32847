/**
 * What a caller states: bodies, materials and the accuracy wanted. Pure values that check
 * themselves at the door, in SI units; knows shapes, but nothing of a pool or of motion.
 */
package rigibo.backend.setup;
