package rigibo.frontend.display;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSFunctor;
import org.teavm.jso.JSObject;

import rigibo.frontend.scene.Link;

/** The page's address, which follows the scene and the player's choices. */
final class Address {

    /**
     * Least time between two updates of the address, ns: browsers refuse much more frequent ones.
     */
    private static final long PAUSE = 1_000_000_000;

    private long looked;
    private String shown = "";

    /** Called when another address was entered. */
    @JSFunctor
    interface Entered extends JSObject {
        void enter();
    }

    /** The text after the {@code #}. */
    String text() {
        shown = fragment();
        return shown;
    }

    /** Sets the function to call whenever the player enters another address of this page. */
    void onEntered(Entered entered) {
        listen(entered);
    }

    /** Called after each picture, with the link to its scene. */
    void turn(Link link) {
        if (System.nanoTime() - looked > PAUSE) {
            looked = System.nanoTime();
            show(link);
        }
    }

    /** Shows a link now; the browser's history stays as it is. */
    void show(Link link) {
        String text = link.text();
        if (!text.equals(shown)) {
            shown = text;
            replace(text);
        }
    }

    /** Offers the address to others; returns whether the system asks the player to whom. */
    boolean offer(String title) {
        return offered(title);
    }

    /** The text after the #; a browser may return it encoded. */
    @JSBody(
            script =
                    "try { return decodeURIComponent(location.hash.substring(1)); }"
                            + " catch (broken) { return '?'; }")
    private static native String fragment();

    @JSBody(params = "entered", script = "addEventListener('hashchange', entered);")
    private static native void listen(Entered entered);

    @JSBody(
            params = "text",
            script =
                    "history.replaceState(null, '', text ? '#' + text"
                            + " : location.pathname + location.search);")
    private static native void replace(String text);

    @JSBody(
            params = "title",
            script =
                    "if (navigator.share) { navigator.share({title: title, url: location.href})"
                            + ".catch(function() {}); return true; } return false;")
    private static native boolean offered(String title);

    /** The whole address, with the scene and the player's choices in it. */
    @JSBody(script = "return location.href;")
    static native String whole();
}
