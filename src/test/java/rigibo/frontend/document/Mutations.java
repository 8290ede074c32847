package rigibo.frontend.document;

import tools.jackson.core.JsonPointer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** A sound file with one value after the other replaced by one that should not be there. */
public final class Mutations {

    private static final String MARK = "here comes another value";

    private static final List<String> VALUES =
            List.of(
                    "null",
                    "true",
                    "-1",
                    "0",
                    "-0",
                    "1.5",
                    "1e-320",
                    "1e308",
                    "-1e308",
                    "1e999",
                    "NaN",
                    "2147483647",
                    "2147483648",
                    "9e15",
                    "99999999999",
                    "\"\"",
                    "\"NaN\"",
                    "\"1e400\"",
                    "\"\\u0000\\n\\u202e\\ud800\"",
                    "\"" + "a-".repeat(2_000) + "\"",
                    "\"" + "a".repeat(100_000) + "\"",
                    "[]",
                    "{}",
                    "[null]",
                    "{\"x\": [[]]}",
                    "[".repeat(1_000) + "]".repeat(1_000));

    /** One of each kind, for whom the others are no different. */
    private static final List<String> KINDS =
            List.of("null", "-1", "9e15", "\"NaN\"", "[]", "{}", "[".repeat(1_000));

    private Mutations() {}

    /** All of a file. */
    public static Stream<String> of(String sound) {
        return of(sound, VALUES);
    }

    /** Some of a file, for tests that take long. */
    public static Stream<String> someOf(String sound) {
        return of(sound, KINDS);
    }

    private static Stream<String> of(String sound, List<String> values) {
        JsonNode root = JsonMapper.shared().readTree(sound);
        List<String> pointers = new ArrayList<>();
        collect(root, "", pointers);
        return pointers.stream().flatMap(pointer -> at(root, pointer, values));
    }

    private static void collect(JsonNode node, String pointer, List<String> pointers) {
        pointers.add(pointer);
        node.properties()
                .forEach(
                        member ->
                                collect(
                                        member.getValue(),
                                        Pointer.member(pointer, member.getKey()),
                                        pointers));
        for (int i = 0; node.isArray() && i < node.size(); i++) {
            collect(node.get(i), pointer + "/" + i, pointers);
        }
    }

    private static Stream<String> at(JsonNode root, String pointer, List<String> values) {
        String marked = marked(root, pointer);
        return values.stream().map(value -> marked.replace("\"" + MARK + "\"", value));
    }

    private static String marked(JsonNode root, String pointer) {
        if (pointer.isEmpty()) {
            return "\"" + MARK + "\"";
        }
        JsonNode copy = root.deepCopy();
        JsonPointer at = JsonPointer.compile(pointer);
        JsonNode around = copy.at(at.head());
        if (around instanceof ArrayNode list) {
            list.set(at.last().getMatchingIndex(), MARK);
        } else {
            ((ObjectNode) around).put(at.last().getMatchingProperty(), MARK);
        }
        return copy.toString();
    }
}
