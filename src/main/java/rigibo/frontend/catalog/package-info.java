/** The list of every scene: the one line to touch when adding one. */
package rigibo.frontend.catalog;
