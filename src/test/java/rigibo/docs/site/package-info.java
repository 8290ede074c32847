/**
 * Makes the site of {@code ./rigibo site}: the Markdown of the checkout as pages, the gallery, and
 * plots of the accuracy that the pages' tables tell. Pages need neither network nor scripts.
 */
package rigibo.docs.site;
