/** Refusals of the reader. */
package tools.jackson.core.exc;
