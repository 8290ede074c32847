/** The kinds of values of a tree. */
package tools.jackson.databind.node;
