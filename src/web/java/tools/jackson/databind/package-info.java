/** The tree of values that JSON tells: what the game calls of the library of this name. */
package tools.jackson.databind;
