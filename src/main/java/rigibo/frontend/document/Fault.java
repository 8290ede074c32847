package rigibo.frontend.document;

import java.util.List;
import java.util.Locale;

/**
 * What is wrong with a value: an exact message for the file's author, and a sentence of the bundles
 * for players.
 *
 * @param kind of the sentence, such as E120; empty if the sentence of the cause is enough
 * @param message what is wrong and what was expected
 * @param values named in the sentence; a word of the bundles is given as {@code @} and its key
 */
public record Fault(String kind, String message, List<String> values) {

    public Fault {
        values = List.copyOf(values);
    }

    /** A fault without a sentence of its own. */
    public static Fault plain(String message) {
        return new Fault("", message, List.of());
    }

    /**
     * A fault whose message names what its sentence names.
     *
     * @param pattern of the message, with a {@code %s} for each value
     */
    public static Fault of(String kind, String pattern, Object... values) {
        List<String> named = List.of(values).stream().map(String::valueOf).toList();
        return new Fault(kind, String.format(Locale.ROOT, pattern, values), named);
    }

    /** The fault as a sentence names these values, whatever the message names. */
    public Fault naming(Object... named) {
        return new Fault(kind, message, List.of(named).stream().map(String::valueOf).toList());
    }
}
