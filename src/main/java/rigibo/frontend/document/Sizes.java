package rigibo.frontend.document;

import tools.jackson.databind.JsonNode;

import java.util.Map;

/**
 * Checks only {@code maxItems} and {@code maxProperties}. A longer list is not read further, since
 * one that is a thousand times too long would give as many problems.
 */
final class Sizes {

    private final JsonNode schema;
    private final Document document;
    private boolean areKept = true;

    private Sizes(JsonNode schema, Document document) {
        this.schema = schema;
        this.document = document;
    }

    /** Whether nothing in a document is longer than its schema allows; otherwise reports it. */
    static boolean areKept(JsonNode schema, Document document) {
        Sizes sizes = new Sizes(schema, document);
        sizes.check(schema, document.root(), "");
        return sizes.areKept;
    }

    private void check(JsonNode rule, JsonNode node, String pointer) {
        JsonNode limit = rule.path(node.isArray() ? "maxItems" : "maxProperties");
        if (limit.isInt() && node.size() > limit.intValue()) {
            areKept = false;
            String words = "must have %s values or fewer, has %s";
            document.error(pointer, () -> Fault.of("schema.long", words, limit, node.size()));
            return;
        }
        if (rule.has("$ref")) {
            check(schema.at(rule.get("$ref").stringValue().substring(1)), node, pointer);
        }
        for (JsonNode also : rule.path("allOf")) {
            check(also.path("then"), node, pointer);
        }
        if (node.isArray() && rule.has("items")) {
            for (int i = 0; i < node.size(); i++) {
                check(rule.get("items"), node.get(i), Pointer.member(pointer, "" + i));
            }
        }
        for (Map.Entry<String, JsonNode> member : rule.path("properties").properties()) {
            String name = member.getKey();
            if (node.has(name)) {
                check(member.getValue(), node.get(name), Pointer.member(pointer, name));
            }
        }
    }
}
