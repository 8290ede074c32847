/**
 * Islands with joints. Joints and contacts become neutral rows, which are solved together: in a
 * small island by elimination of all equations and of the loaded bounds, in a large one equations
 * are eliminated and the rest is passed over. SI units; a row's impulse is N·s, or N·m·s where it
 * turns.
 */
package rigibo.backend.contact.joint;
