package rigibo.frontend.document;

import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.exc.StreamConstraintsException;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;

/**
 * Reads one JSON document within {@link Bounds}. The library's own tree reader would stop at the
 * first duplicate key, but an author needs all of them at once.
 */
final class JsonParsing {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private static final JsonFactory FACTORY =
            JsonFactory.builder().streamReadConstraints(Bounds.OF_PARSER).build();

    private final String text;
    private final JsonParser parser;
    private final Problems problems;

    /** The names and indices that lead to the present value, innermost first. */
    private final Deque<Object> path = new ArrayDeque<>();

    private JsonParsing(String text, JsonParser parser, Problems problems) {
        this.text = text;
        this.parser = parser;
        this.problems = problems;
    }

    static JsonParser parser(String text) {
        return FACTORY.createParser(ObjectReadContext.empty(), text);
    }

    /**
     * Reads the outermost value; returns nothing, after reporting the problem, if the text is no
     * JSON.
     */
    static Optional<JsonNode> parse(String text, Problems problems) {
        try (JsonParser parser = parser(text)) {
            return new JsonParsing(text, parser, problems).document();
        }
    }

    private Optional<JsonNode> document() {
        try {
            if (parser.nextToken() == null) {
                problems.refuse(Cause.DAMAGED, "the file is empty");
                return Optional.empty();
            }
            JsonNode root = value();
            if (parser.nextToken() != null) {
                problems.error(Cause.DAMAGED, here(), "", "not JSON: text after the end");
                return Optional.empty();
            }
            return Optional.of(root);
        } catch (StreamConstraintsException beyond) {
            String words = "more than we read: " + words(beyond);
            problems.error(Cause.TOO_LARGE, here(), pointer(), words);
            return Optional.empty();
        } catch (JacksonException broken) {
            Place place = broken.getLocation() == null ? here() : Place.of(broken.getLocation());
            problems.error(Cause.DAMAGED, place, pointer(), "not JSON: " + words(broken));
            return Optional.empty();
        }
    }

    private JsonNode value() {
        return switch (parser.currentToken()) {
            case START_OBJECT -> object();
            case START_ARRAY -> array();
            case VALUE_STRING -> NODES.stringNode(parser.getString());
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> number();
            case VALUE_NULL -> NODES.nullNode();
            case VALUE_TRUE -> NODES.booleanNode(true);
            case VALUE_FALSE -> NODES.booleanNode(false);
            case END_OBJECT, END_ARRAY, PROPERTY_NAME, VALUE_EMBEDDED_OBJECT, NOT_AVAILABLE ->
                    throw new IllegalStateException(
                            "no value begins with " + parser.currentToken());
        };
    }

    private JsonNode object() {
        ObjectNode object = NODES.objectNode();
        int outside = path.size();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
            String name = parser.currentName();
            leaveTo(outside);
            path.push(name);
            boolean isFirst = !object.has(name);
            if (!isFirst) {
                tellSecond(name);
            }
            parser.nextToken();
            JsonNode value = value();
            if (isFirst) {
                object.set(name, value);
            }
        }
        leaveTo(outside);
        return object;
    }

    private void tellSecond(String name) {
        if (problems.isFull()) {
            problems.count(Problem.Severity.ERROR);
            return;
        }
        Place first = PlaceSearch.of(text, pointer()).name();
        String twice = "%s is given twice (first at %s)";
        problems.error(
                here(), pointer(), Fault.of("schema.twice", twice, Escape.quoted(name), first));
    }

    private JsonNode array() {
        ArrayNode array = NODES.arrayNode();
        int outside = path.size();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            leaveTo(outside);
            path.push(array.size());
            array.add(value());
        }
        leaveTo(outside);
        return array;
    }

    /**
     * Between two elements the path still leads to the first, since that is where the author looks.
     */
    private void leaveTo(int length) {
        while (path.size() > length) {
            path.pop();
        }
    }

    private JsonNode number() {
        String digits = parser.getString();
        double number = digits.length() <= Bounds.NUMBER ? Double.parseDouble(digits) : Double.NaN;
        if (!(Math.abs(number) <= Bounds.LARGEST)) {
            String large = "the number %s is too large";
            problems.error(
                    here(), pointer(), Fault.of("schema.number", large, Escape.shortened(digits)));
            return NODES.numberNode(0);
        }
        boolean isInt =
                number == (int) number && parser.currentToken() == JsonToken.VALUE_NUMBER_INT;
        return isInt ? NODES.numberNode((int) number) : NODES.numberNode(number);
    }

    private String pointer() {
        String pointer = "";
        for (Iterator<Object> steps = path.descendingIterator(); steps.hasNext(); ) {
            pointer = Pointer.member(pointer, steps.next().toString());
        }
        return pointer;
    }

    private Place here() {
        return Place.of(parser.currentTokenLocation());
    }

    /** The parser's message, without the source and the option that the parser adds. */
    private static String words(JacksonException broken) {
        return broken.getOriginalMessage()
                .replaceFirst(" *\\([^()]*\\[Source: .*", "")
                .replaceFirst(", from `[^`]*`", "");
    }
}
