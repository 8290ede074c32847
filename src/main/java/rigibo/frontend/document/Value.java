package rigibo.frontend.document;

import tools.jackson.databind.JsonNode;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.regex.Pattern;

/**
 * A value of a document, read as the expected type. A value of another type is reported as a
 * problem and replaced by a default, so that reading goes on and all problems are reported at once.
 */
public final class Value {

    private final Document document;
    private final JsonNode node;

    /** Makes the pointer, which is needed only if a problem is reported. */
    private final Supplier<String> pointer;

    Value(Document document) {
        this(document, document.root(), () -> "");
    }

    private Value(Document document, JsonNode node, Supplier<String> pointer) {
        this.document = document;
        this.node = node;
        this.pointer = pointer;
    }

    /** An optional member; if it is missing, every question about it returns the given default. */
    public Value optional(String member) {
        return new Value(document, node.path(member), () -> Pointer.member(pointer.get(), member));
    }

    /** This value, which must be an object, since nothing else has members. */
    public Value object() {
        is("an object", JsonNode::isObject, any -> any, node);
        return this;
    }

    /** A required member of an object. */
    public Value required(String member) {
        if (node.isObject() && !node.has(member)) {
            error(() -> Escape.quoted(member) + " is missing");
        }
        return optional(member);
    }

    /** The names of the members; none if this is no object. */
    public Collection<String> members() {
        return node.propertyNames();
    }

    /** Whether the file states it. */
    public boolean isThere() {
        return !node.isMissingNode();
    }

    /** A text. */
    public String text(String instead) {
        return is("a text", JsonNode::isString, JsonNode::stringValue, instead);
    }

    /**
     * A text of a required form.
     *
     * @param shape the required form, in words
     */
    public String text(Pattern pattern, String shape, String instead) {
        return is(
                shape,
                any -> any.isString() && pattern.matcher(any.stringValue()).matches(),
                JsonNode::stringValue,
                instead);
    }

    /** Reads true or false. */
    public boolean truth(boolean instead) {
        return is("true or false", JsonNode::isBoolean, JsonNode::booleanValue, instead);
    }

    /** A number from {@code least} to {@code most}. */
    public double number(double least, double most, double instead) {
        return is(
                "a number from " + least + " to " + most,
                any -> any.isNumber() && any.doubleValue() >= least && any.doubleValue() <= most,
                JsonNode::doubleValue,
                instead);
    }

    /** A whole number from {@code least} to {@code most}; 2.0 counts as one. */
    public int whole(int least, int most, int instead) {
        return is(
                "a whole number from " + least + " to " + most,
                any ->
                        any.isNumber()
                                && any.doubleValue() >= least
                                && any.doubleValue() <= most
                                && any.doubleValue() == Math.rint(any.doubleValue()),
                any -> (int) any.doubleValue(),
                instead);
    }

    /** One of the given words. */
    public String word(Collection<String> words, String instead) {
        return is(
                "one of " + Suggestion.list(words.stream().sorted().toList()),
                any -> any.isString() && words.contains(any.stringValue()),
                JsonNode::stringValue,
                instead);
    }

    /** An enum constant by its name in lower case. */
    public <E extends Enum<E>> E word(Class<E> kind, E instead) {
        Map<String, E> constants = new LinkedHashMap<>();
        for (E constant : kind.getEnumConstants()) {
            constants.put(constant.name().toLowerCase(Locale.ROOT), constant);
        }
        String name = instead.name().toLowerCase(Locale.ROOT);
        return constants.get(word(constants.keySet(), name));
    }

    private <T> T is(
            String kind, Predicate<JsonNode> isSound, Function<JsonNode, T> read, T instead) {
        if (isSound.test(node)) {
            return read.apply(node);
        }
        if (isThere()) {
            wrong("must be " + kind);
        }
        return instead;
    }

    /** Reports what this must be, and what was found instead. */
    public void wrong(String must) {
        error(() -> must + ", was " + Escape.shown(node));
    }

    private void error(Supplier<String> message) {
        document.error(pointer, () -> Fault.plain(message.get()));
    }
}
