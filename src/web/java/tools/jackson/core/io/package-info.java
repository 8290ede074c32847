/** What writes texts as JSON has them. */
package tools.jackson.core.io;
