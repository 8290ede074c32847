/** What a value of another kind answers. */
package tools.jackson.databind.exc;
