/**
 * Moving pictures of scenes, as GIF files. The one room beside the laboratory's plots that uses
 * AWT, for its pictures of indexed colours: nothing of the game knows it, only the command line
 * does. Sizes in px, colours as 0xRRGGBB, times in s.
 */
package rigibo.film;
