package rigibo.fuzz.file;

import rigibo.fuzz.chance.Chance;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Mutates a document so that it stays JSON, or almost. */
final class JsonMutation {

    /**
     * A placeholder in the tree for text that no tree can hold; it is replaced when the tree is
     * written.
     */
    private static final String MARK = "@@here@@";

    private static final JsonMapper JSON = JsonMapper.builder().build();

    /** A value and its place. */
    private record Spot(JsonNode parent, String key, int index) {

        JsonNode value() {
            return parent.isObject() ? parent.get(key) : parent.get(index);
        }

        void replace(String text) {
            if (parent instanceof ObjectNode object) {
                object.put(key, text);
            } else {
                ArrayNode array = (ArrayNode) parent;
                array.set(index, array.stringNode(text));
            }
        }
    }

    private final Chance chance;
    private final List<Spot> spots = new ArrayList<>();

    JsonMutation(Chance chance) {
        this.chance = chance;
    }

    /** The mutated bytes of a document. */
    byte[] of(byte[] whole) {
        JsonNode root = JSON.readTree(whole);
        collect(root);
        Spot spot = chance.oneOf(spots);
        String text =
                switch (chance.whole(0, 9)) {
                    case 0 -> removed(root, spot);
                    case 1 -> renamed(root, spot);
                    case 2 -> doubled(root, spot);
                    case 3 -> multiplied(root);
                    case 4 -> swapped(root, spot);
                    default -> replaced(root, spot, new Junk(chance).value());
                };
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private void collect(JsonNode node) {
        if (node.isObject()) {
            node.properties().forEach(entry -> spots.add(new Spot(node, entry.getKey(), -1)));
            node.properties().forEach(entry -> collect(entry.getValue()));
        }
        if (node.isArray()) {
            for (int i = 0; i < node.size(); i++) {
                spots.add(new Spot(node, "", i));
                collect(node.get(i));
            }
        }
    }

    private static String replaced(JsonNode root, Spot spot, String raw) {
        spot.replace(MARK);
        return marked(root, raw);
    }

    private static String marked(JsonNode root, String raw) {
        return root.toString().replace('"' + MARK + '"', raw);
    }

    private static String removed(JsonNode root, Spot spot) {
        if (spot.parent() instanceof ObjectNode object) {
            object.remove(spot.key());
        } else {
            ((ArrayNode) spot.parent()).remove(spot.index());
        }
        return root.toString();
    }

    /** Renames a key: another case, escapes, endless, empty. */
    private String renamed(JsonNode root, Spot spot) {
        if (!(spot.parent() instanceof ObjectNode object)) {
            return removed(root, spot);
        }
        JsonNode value = object.remove(spot.key());
        object.set(MARK, value);
        return marked(root, new Junk(chance).key(spot.key()));
    }

    /** Duplicates a key of an object, possibly with another value, or an element of a list. */
    private String doubled(JsonNode root, Spot spot) {
        String value = spot.value().toString();
        String other = chance.happens(0.5) ? value : new Junk(chance).value();
        String key = spot.parent().isObject() ? JSON.writeValueAsString(spot.key()) + ":" : "";
        return replaced(root, spot, value + "," + key + other);
    }

    /** Repeats the elements of a list many times. */
    private String multiplied(JsonNode root) {
        List<Spot> lists =
                spots.stream()
                        .filter(spot -> spot.value().isArray() && !spot.value().isEmpty())
                        .toList();
        if (lists.isEmpty()) {
            return root.toString().repeat(2);
        }
        Spot spot = chance.oneOf(lists);
        String elements = spot.value().toString();
        String some = elements.substring(1, elements.length() - 1);
        int most = Math.max(1, Junk.MOST_CHARACTERS / some.length());
        int times = (int) chance.ofAnySize(1, most);
        return replaced(root, spot, "[" + (some + ",").repeat(times) + some + "]");
    }

    /** Replaces a value by another value of the document. */
    private String swapped(JsonNode root, Spot spot) {
        return replaced(root, spot, chance.oneOf(spots).value().toString());
    }
}
