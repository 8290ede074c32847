package rigibo.frontend.puzzle.level;

import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Reads one JSON document with the place of every value. The library's own tree reader would stop
 * at the first duplicate key and keep no places; an author wants all of it at once.
 */
public final class JsonParsing {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final JsonParser parser;
    private final Problems problems;
    private final Map<String, Place> places = new HashMap<>();
    private String pointer = "";

    private JsonParsing(JsonParser parser, Problems problems) {
        this.parser = parser;
        this.problems = problems;
    }

    /** The document, or nothing after telling why the text is no JSON. */
    public static Optional<LocatedJson> parse(String text, Problems problems) {
        try (JsonParser parser =
                JsonFactory.builder()
                        .build()
                        .createParser(tools.jackson.core.ObjectReadContext.empty(), text)) {
            return new JsonParsing(parser, problems).document();
        }
    }

    private Optional<LocatedJson> document() {
        try {
            if (parser.nextToken() == null) {
                problems.error(Place.START, "", "the file is empty");
                return Optional.empty();
            }
            JsonNode root = value();
            if (parser.nextToken() != null) {
                problems.error(here(), "", "not JSON: text after the end");
                return Optional.empty();
            }
            return Optional.of(new LocatedJson(root, places));
        } catch (JacksonException broken) {
            Place place = broken.getLocation() == null ? here() : place(broken.getLocation());
            problems.error(place, pointer, "not JSON: " + words(broken));
            return Optional.empty();
        }
    }

    private JsonNode value() {
        places.put(pointer, here());
        JsonToken token = parser.currentToken();
        if (token == JsonToken.START_OBJECT) {
            return object();
        }
        if (token == JsonToken.START_ARRAY) {
            return array();
        }
        if (token == JsonToken.VALUE_STRING) {
            return NODES.stringNode(parser.getString());
        }
        if (token.isNumeric()) {
            return number();
        }
        return token == JsonToken.VALUE_NULL
                ? NODES.nullNode()
                : NODES.booleanNode(token == JsonToken.VALUE_TRUE);
    }

    private JsonNode object() {
        ObjectNode object = NODES.objectNode();
        Map<String, Place> names = new HashMap<>();
        String outer = pointer;
        while (parser.nextToken() != JsonToken.END_OBJECT) {
            String name = parser.currentName();
            pointer = member(outer, name);
            Place first = names.putIfAbsent(name, here());
            if (first != null) {
                String twice = "\"" + name + "\" is given twice (first at " + first + ")";
                problems.error(here(), pointer, twice);
            }
            parser.nextToken();
            object.set(name, value());
        }
        pointer = outer;
        return object;
    }

    private JsonNode array() {
        ArrayNode array = NODES.arrayNode();
        String outer = pointer;
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            pointer = outer + "/" + array.size();
            array.add(value());
        }
        pointer = outer;
        return array;
    }

    private JsonNode number() {
        String digits = parser.getString();
        double number = Double.parseDouble(digits);
        if (Double.isInfinite(number)) {
            problems.error(here(), pointer, "the number " + shortened(digits) + " is too large");
            return NODES.numberNode(0);
        }
        boolean isWhole = number == Math.rint(number) && Math.abs(number) < Integer.MAX_VALUE;
        return isWhole && parser.currentToken() == JsonToken.VALUE_NUMBER_INT
                ? NODES.numberNode((int) number)
                : NODES.numberNode(number);
    }

    /** A pointer's next step, escaped as RFC 6901 asks. */
    static String member(String pointer, String name) {
        return pointer + "/" + name.replace("~", "~0").replace("/", "~1");
    }

    private static String shortened(String digits) {
        final int shown = 20;
        return digits.length() <= shown ? digits : digits.substring(0, shown) + "…";
    }

    private Place here() {
        return place(parser.currentTokenLocation());
    }

    private static Place place(TokenStreamLocation location) {
        return new Place(Math.max(1, location.getLineNr()), Math.max(1, location.getColumnNr()));
    }

    /** What the parser says, without where it thinks the text came from. */
    private static String words(JacksonException broken) {
        return broken.getOriginalMessage().replaceFirst(" *\\([^()]*\\[Source: .*", "");
    }
}
