package rigibo.frontend.display;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSFunctor;
import org.teavm.jso.JSObject;

import rigibo.frontend.scene.Link;

/** The page's address, which follows what is shown and chosen. */
final class Address {

    /** Between two looks at what is chosen, ns: browsers refuse to be told much more often. */
    private static final long PAUSE = 1_000_000_000;

    private long looked;
    private String shown = "";

    /** What a page tells that its address was entered anew. */
    @JSFunctor
    interface Entered extends JSObject {
        void enter();
    }

    /** The text after the {@code #}. */
    String text() {
        shown = fragment();
        return shown;
    }

    /** Calls whenever the player enters another address of this page. */
    void onEntered(Entered entered) {
        listen(entered);
    }

    /** A picture was drawn of what a link leads to. */
    void turn(Link link) {
        if (System.nanoTime() - looked > PAUSE) {
            looked = System.nanoTime();
            show(link);
        }
    }

    /** Shows a link now; the way back of the browser stays as it is. */
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

    /** A browser may hand it out encoded. */
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

    /** All of it, with the scene and what is chosen in it. */
    @JSBody(script = "return location.href;")
    static native String whole();
}
