package tools.jackson.core;

import tools.jackson.core.exc.StreamConstraintsException;

import java.util.ArrayDeque;
import java.util.Deque;

/** Reads a JSON text (RFC 8259) part by part. */
public final class JsonParser implements AutoCloseable {

    private static final String NUMBER = "+-.0123456789eE";

    private final String text;
    private final StreamReadConstraints bounds;
    private final Deque<JsonToken> open = new ArrayDeque<>();
    private int at;
    private int line = 1;
    private int lineStart;
    private long tokens;
    private JsonToken token = JsonToken.NOT_AVAILABLE;
    private TokenStreamLocation location = new TokenStreamLocation(1, 1);
    private String name;
    private String value;
    private boolean isOver;

    public JsonParser(String text, StreamReadConstraints bounds) {
        this.text = text;
        this.bounds = bounds;
        location = new TokenStreamLocation(1, 1);
        if (text.length() > bounds.document) {
            throw beyond("the text is longer than " + bounds.document);
        }
    }

    /** The next part; null after the last. */
    public JsonToken nextToken() {
        skipSpace();
        location = here();
        boolean isEmpty = token == JsonToken.START_OBJECT || token == JsonToken.START_ARRAY;
        if (open.isEmpty()) {
            if (at == text.length()) {
                token = null;
                return null;
            }
            if (isOver) {
                // Any text after the end is a part too many.
                return JsonToken.NOT_AVAILABLE;
            }
            token = value();
        } else if (token == JsonToken.PROPERTY_NAME) {
            expect(':');
            skipSpace();
            location = here();
            token = value();
        } else if (peek() == (isInObject() ? '}' : ']')) {
            at++;
            token =
                    open.pop() == JsonToken.START_OBJECT
                            ? JsonToken.END_OBJECT
                            : JsonToken.END_ARRAY;
        } else {
            if (!isEmpty) {
                expect(',');
                skipSpace();
                location = here();
            }
            token = isInObject() ? propertyName() : value();
        }
        isOver = open.isEmpty();
        if (++tokens > bounds.tokens) {
            throw beyond("there are more than " + bounds.tokens + " values");
        }
        return token;
    }

    private boolean isInObject() {
        return open.peek() == JsonToken.START_OBJECT;
    }

    private JsonToken propertyName() {
        if (peek() != '"') {
            throw broken("a name in quotes must come here");
        }
        name = string(bounds.name);
        return JsonToken.PROPERTY_NAME;
    }

    private JsonToken value() {
        char first = peek();
        if (first == '{' || first == '[') {
            at++;
            JsonToken start = first == '{' ? JsonToken.START_OBJECT : JsonToken.START_ARRAY;
            open.push(start);
            if (open.size() > bounds.depth) {
                throw beyond("values are nested deeper than " + bounds.depth);
            }
            return start;
        }
        if (first == '"') {
            value = string(bounds.string);
            return JsonToken.VALUE_STRING;
        }
        if (first == '-' || first >= '0' && first <= '9') {
            return number();
        }
        return word();
    }

    private JsonToken word() {
        int begin = at;
        while (at < text.length() && Character.isLetterOrDigit(text.charAt(at))) {
            at++;
        }
        value = text.substring(begin, at);
        return switch (value) {
            case "true" -> JsonToken.VALUE_TRUE;
            case "false" -> JsonToken.VALUE_FALSE;
            case "null" -> JsonToken.VALUE_NULL;
            default -> throw broken("no value begins here");
        };
    }

    private JsonToken number() {
        int begin = at;
        while (at < text.length() && NUMBER.indexOf(text.charAt(at)) >= 0) {
            at++;
        }
        value = text.substring(begin, at);
        if (value.length() > bounds.number) {
            throw beyond("a number has more than " + bounds.number + " digits");
        }
        if (!value.matches("-?(0|[1-9]\\d*)(\\.\\d+)?([eE][-+]?\\d+)?")) {
            throw broken("this is no number");
        }
        boolean isInt = value.matches("-?\\d+");
        return isInt ? JsonToken.VALUE_NUMBER_INT : JsonToken.VALUE_NUMBER_FLOAT;
    }

    private String string(int most) {
        StringBuilder read = new StringBuilder();
        at++;
        while (peek() != '"') {
            char letter = text.charAt(at++);
            if (letter < ' ') {
                throw broken("a text may not hold a line's end or another control character");
            }
            read.append(letter == '\\' ? escaped() : letter);
            if (read.length() > most) {
                throw beyond("a text is longer than " + most);
            }
        }
        at++;
        return read.toString();
    }

    private char escaped() {
        char kind = peek();
        at++;
        return switch (kind) {
            case '"', '\\', '/' -> kind;
            case 'b' -> '\b';
            case 'f' -> '\f';
            case 'n' -> '\n';
            case 'r' -> '\r';
            case 't' -> '\t';
            case 'u' -> codeUnit();
            default -> throw broken("no escape is called \\" + kind);
        };
    }

    private char codeUnit() {
        int code = 0;
        for (int i = 0; i < 4; i++) {
            int digit = Character.digit(peek(), 16);
            if (digit < 0) {
                throw broken("four hexadecimal digits must follow \\u");
            }
            code = 16 * code + digit;
            at++;
        }
        return (char) code;
    }

    private void skipSpace() {
        while (at < text.length() && " \t\r\n".indexOf(text.charAt(at)) >= 0) {
            if (text.charAt(at++) == '\n') {
                line++;
                lineStart = at;
            }
        }
    }

    private char peek() {
        if (at >= text.length()) {
            throw broken("the end is missing");
        }
        return text.charAt(at);
    }

    private void expect(char sign) {
        if (peek() != sign) {
            throw broken("'" + sign + "' must come here");
        }
        at++;
    }

    private TokenStreamLocation here() {
        return new TokenStreamLocation(line, at - lineStart + 1);
    }

    private JacksonException broken(String why) {
        return new JacksonException(why, here());
    }

    private JacksonException beyond(String why) {
        return new StreamConstraintsException(why, here());
    }

    public JsonToken currentToken() {
        return token;
    }

    public String currentName() {
        return name;
    }

    public String getString() {
        return value;
    }

    public TokenStreamLocation currentTokenLocation() {
        return location;
    }

    /** Skips to the end of the object or list that has begun. */
    public JsonParser skipChildren() {
        if (token == JsonToken.START_OBJECT || token == JsonToken.START_ARRAY) {
            int outside = open.size() - 1;
            while (open.size() > outside) {
                nextToken();
            }
        }
        return this;
    }

    @Override
    public void close() {}
}
