/** Writes texts as in JSON. */
package tools.jackson.core.io;
