/**
 * A reader of JSON by the names of the library that the desktop reads with, which no browser runs:
 * what the room {@code document} calls of it, and nothing else.
 */
package tools.jackson.core;
