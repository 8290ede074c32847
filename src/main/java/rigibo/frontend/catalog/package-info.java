/** The list of all scenes; a new scene adds one line here. */
package rigibo.frontend.catalog;
