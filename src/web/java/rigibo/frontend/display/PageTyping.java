package rigibo.frontend.display;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSFunctor;
import org.teavm.jso.JSObject;

/**
 * Opens the keyboard of a screen. Browsers show it for a field of the document only, so there is an
 * invisible field; text typed there is passed on as characters and keys.
 */
final class PageTyping {

    private PageTyping() {}

    /** Receives typed text. */
    @JSFunctor
    interface Taker extends JSObject {
        /**
         * @param removed number of letters before the typed ones to remove
         * @param typed letters
         */
        void take(int removed, String typed);
    }

    /** Called when typing ends. */
    @JSFunctor
    interface Ender extends JSObject {
        void end();
    }

    /**
     * Keyboards that complete words replace letters at any place, so a change is found by comparing
     * with the former text. The field is filled with blanks, so that there are letters to remove.
     */
    @JSBody(
            params = {"taker", "ender"},
            script =
                    "var field = document.getElementById('typing'); var blank = ' '.repeat(200);"
                            + " var before = blank;"
                            + " field.addEventListener('focus', function() {"
                            + " field.value = before = blank; });"
                            + " field.addEventListener('keydown', function(event) {"
                            + " if (event.key === 'Enter') { event.preventDefault();"
                            + " event.stopPropagation(); ender(); } });"
                            + " field.addEventListener('input', function() {"
                            + " var now = field.value; var same = 0;"
                            + " while (same < now.length && now[same] === before[same]) { same++; }"
                            + " taker(before.length - same, now.slice(same)); before = now; });")
    static native void listen(Taker taker, Ender ender);

    /** Shows or hides the keyboard. Must be called while a touch is handled, or browsers refuse. */
    @JSBody(
            params = "isOn",
            script =
                    "var field = document.getElementById('typing'); if (isOn) { field.focus(); }"
                            + " else if (document.activeElement === field) { field.blur(); }")
    static native void show(boolean isOn);
}
