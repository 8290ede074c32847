package tools.jackson.core;

/** A path to a value of a tree, as in RFC 6901. */
public final class JsonPointer {

    private final String text;

    private JsonPointer(String text) {
        this.text = text;
    }

    public static JsonPointer compile(String text) {
        return new JsonPointer(text);
    }

    /** Whether it has no further steps. */
    public boolean matches() {
        return text.isEmpty();
    }

    /** The first step, as a name. */
    public String getMatchingProperty() {
        return text.substring(1, end()).replace("~1", "/").replace("~0", "~");
    }

    /** The first step, as an index of a list; -1 if it is none. */
    public int getMatchingIndex() {
        String name = getMatchingProperty();
        return name.matches("\\d{1,9}") ? Integer.parseInt(name) : -1;
    }

    /** All steps but the first. */
    public JsonPointer tail() {
        return new JsonPointer(text.substring(end()));
    }

    /** All steps but the last. */
    public JsonPointer head() {
        return new JsonPointer(text.substring(0, text.lastIndexOf('/')));
    }

    /** The last step alone. */
    public JsonPointer last() {
        return new JsonPointer(text.substring(text.lastIndexOf('/')));
    }

    private int end() {
        int next = text.indexOf('/', 1);
        return next < 0 ? text.length() : next;
    }

    @Override
    public String toString() {
        return text;
    }
}
