package rigibo.frontend.display;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSFunctor;
import org.teavm.jso.JSObject;

/**
 * Brings up the keyboard of a screen. Browsers show it for a field of the document alone, so there
 * is one that nobody sees; what is typed into it goes on as characters and keys.
 */
final class PageTyping {

    private PageTyping() {}

    /** Takes what was typed. */
    @JSFunctor
    interface Taker extends JSObject {
        /**
         * @param removed letters before those that were typed
         * @param typed letters
         */
        void take(int removed, String typed);
    }

    /** Takes that typing is over. */
    @JSFunctor
    interface Ender extends JSObject {
        void end();
    }

    /**
     * Keyboards that complete words replace letters at will: what has changed is found by comparing
     * with what stood there before. The field is filled with blanks, so that there is something to
     * take back.
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

    /** Shows the keyboard, or hides it; called while a touch is handled, or browsers refuse. */
    @JSBody(
            params = "isOn",
            script =
                    "var field = document.getElementById('typing'); if (isOn) { field.focus(); }"
                            + " else if (document.activeElement === field) { field.blur(); }")
    static native void show(boolean isOn);
}
