package rigibo.frontend.puzzle;

import rigibo.frontend.document.Fault;
import rigibo.frontend.document.Problem;
import rigibo.frontend.scene.Words;

/** Problems of levels in the player's language. */
public final class ProblemWords {

    /** Prefix of a key of the bundles. */
    private static final String KEY = "@";

    private ProblemWords() {}

    /** Names the problem in a few words. */
    public static String title(Words words, Problem problem) {
        return words.of("editor.problem." + problem.fault().kind().replaceFirst("\\..*", ""));
    }

    /**
     * States the problem and its remedy in a sentence; for a fault without a sentence of its own,
     * the general reason.
     */
    public static String told(Words words, Problem problem) {
        Fault fault = problem.fault();
        if (fault.kind().isEmpty()) {
            return words.of(problem.cause().key());
        }
        Object[] values = fault.values().stream().map(value -> named(words, value)).toArray();
        return words.of("editor.problem." + fault.kind() + ".told", values);
    }

    private static String named(Words words, String value) {
        return value.startsWith(KEY) ? words.of(value.substring(KEY.length())) : value;
    }
}
