/** What writes a tree. */
package tools.jackson.databind.json;
