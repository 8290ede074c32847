/**
 * The gallery as a page: an exhibit runs in the browser and is drawn on its two-dimensional canvas.
 * Knows the document and the engine's public face. Lengths on the canvas are its own pixels.
 */
package rigibo.web.gallery;
