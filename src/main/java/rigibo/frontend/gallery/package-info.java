/**
 * The gallery: small programs of the engine as pictures to choose from, each of which opens as a
 * running scene. A program is a class that implements {@link rigibo.frontend.gallery.Exhibit} and a
 * line that registers it, by which {@link java.util.ServiceLoader} finds it. World coordinates are
 * metres, y up.
 */
package rigibo.frontend.gallery;
