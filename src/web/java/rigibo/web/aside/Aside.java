package rigibo.web.aside;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSFunctor;
import org.teavm.jso.JSObject;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * A thread that does one errand beside the page: a worker of the browser, which runs this same
 * program with the words of the errand as its arguments.
 */
public final class Aside {

    private final JSObject worker;

    private Aside(JSObject worker) {
        this.worker = worker;
    }

    /** Receives words from the browser. */
    @JSFunctor
    interface Taker extends JSObject {
        void take(String[] words);
    }

    /**
     * Begins an errand.
     *
     * @param told receives each report of the thread, some words; an empty list if it failed
     */
    public static Aside begin(String errand, List<String> words, Consumer<List<String>> told) {
        List<String> all = new ArrayList<>(List.of(errand));
        all.addAll(words);
        return new Aside(start(all.toArray(new String[0]), said -> told.accept(List.of(said))));
    }

    /** Ends the thread, whatever it does. */
    public void stop() {
        end(worker);
    }

    /** Reports some words to the page; called by the thread. */
    public static void tell(List<String> words) {
        post(words.toArray(new String[0]));
    }

    @JSBody(
            params = {"words", "taker"},
            script =
                    "var worker = new Worker('aside.js');"
                            + " worker.onmessage = function(said) { taker(said.data); };"
                            + " worker.onerror = function() { taker([]); };"
                            + " worker.postMessage(words); return worker;")
    private static native JSObject start(String[] words, Taker taker);

    @JSBody(params = "worker", script = "worker.terminate();")
    private static native void end(JSObject worker);

    @JSBody(params = "words", script = "self.postMessage(words);")
    private static native void post(String[] words);
}
