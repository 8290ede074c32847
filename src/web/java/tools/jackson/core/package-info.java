/**
 * A reader of JSON under the names of the desktop's library, which no browser runs. It has the
 * parts that the room {@code document} uses, and no others.
 */
package tools.jackson.core;
