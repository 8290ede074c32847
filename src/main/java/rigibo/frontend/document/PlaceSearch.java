package rigibo.frontend.document;

import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

import java.util.List;

/** Finds the position of a value in a text, reading it from the start. */
final class PlaceSearch {

    private final JsonParser parser;
    private Found found;

    /**
     * Where a value was found.
     *
     * @param name where its name begins; if it has none, where the value begins
     * @param value where it begins
     */
    record Found(Place name, Place value) {}

    private PlaceSearch(JsonParser parser) {
        this.parser = parser;
    }

    /** The value at a pointer, or the nearest around it; the text must be JSON up to there. */
    static Found of(String text, String pointer) {
        try (JsonParser parser = JsonParsing.parser(text)) {
            return new PlaceSearch(parser).search(Pointer.steps(pointer));
        }
    }

    private Found search(List<String> steps) {
        parser.nextToken();
        found = new Found(here(), here());
        for (String step : steps) {
            boolean isThere =
                    parser.currentToken() == JsonToken.START_OBJECT
                            ? enterMember(step)
                            : parser.currentToken() == JsonToken.START_ARRAY && enterElement(step);
            if (!isThere) {
                break;
            }
        }
        return found;
    }

    private boolean enterMember(String name) {
        while (parser.nextToken() != JsonToken.END_OBJECT) {
            Place named = here();
            boolean isIt = parser.currentName().equals(name);
            parser.nextToken();
            if (isIt) {
                found = new Found(named, here());
                return true;
            }
            parser.skipChildren();
        }
        return false;
    }

    private boolean enterElement(String index) {
        int left = Pointer.index(index);
        while (left >= 0 && parser.nextToken() != JsonToken.END_ARRAY) {
            if (left-- == 0) {
                found = new Found(here(), here());
                return true;
            }
            parser.skipChildren();
        }
        return false;
    }

    private Place here() {
        return Place.of(parser.currentTokenLocation());
    }
}
