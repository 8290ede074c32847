/**
 * The gallery: small programs of the engine as pictures to choose from, each of which opens as a
 * running scene. A program is a class that implements {@link rigibo.frontend.gallery.Exhibit} and a
 * line that registers it; the game finds it by {@link java.util.ServiceLoader}. World coordinates
 * are metres, y up.
 */
package rigibo.frontend.gallery;
