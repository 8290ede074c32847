/** The tree of values of a JSON text: the parts of the library of this name that the game uses. */
package tools.jackson.databind;
