/** Makes and writes trees. */
package tools.jackson.databind.json;
