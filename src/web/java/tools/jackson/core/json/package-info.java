/** Makes readers. */
package tools.jackson.core.json;
