package rigibo.frontend.display;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSFunctor;
import org.teavm.jso.JSObject;

/**
 * The browser's clipboard. The browser may refuse, or ask the player first, and has none where the
 * page comes by HTTP from another machine.
 */
final class Clipboard {

    private Clipboard() {}

    /** Takes a text from the browser. */
    @JSFunctor
    interface Taker extends JSObject {
        void take(String text);
    }

    /** Called with the outcome of copying a text. */
    @JSFunctor
    interface Outcome extends JSObject {
        void take(boolean isCopied);
    }

    /** Passes the clipboard's text on; an empty one if it may not be read. */
    @JSBody(
            params = "taker",
            script =
                    "var none = function() { taker(''); };"
                            + " try { navigator.clipboard.readText().then(taker, none); }"
                            + " catch (missing) { none(); }")
    static native void read(Taker taker);

    /** Copies a text, and reports whether that was allowed. */
    @JSBody(
            params = {"text", "outcome"},
            script =
                    "var no = function() { outcome(false); };"
                            + " try { navigator.clipboard.writeText(text)"
                            + ".then(function() { outcome(true); }, no); }"
                            + " catch (missing) { no(); }")
    static native void write(String text, Outcome outcome);
}
