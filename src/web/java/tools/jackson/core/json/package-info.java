/** What makes a reader. */
package tools.jackson.core.json;
