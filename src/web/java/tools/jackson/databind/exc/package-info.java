/** Exceptions about values of another kind. */
package tools.jackson.databind.exc;
