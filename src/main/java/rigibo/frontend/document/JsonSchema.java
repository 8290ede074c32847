package rigibo.frontend.document;

import com.networknt.schema.Error;
import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import com.networknt.schema.path.NodePath;

import tools.jackson.databind.JsonNode;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.StreamSupport;

/** Compares a file with its JSON schema and describes the differences. */
public final class JsonSchema {

    private final Schema schema;

    /** Loads a schema by its name from the class path's resources. */
    public JsonSchema(String resource) {
        schema =
                SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                        .getSchema(text(resource), InputFormat.JSON);
    }

    private static String text(String resource) {
        try (InputStream in = JsonSchema.class.getResourceAsStream(resource)) {
            if (in == null) {
                throw new IllegalStateException(resource + " is missing from the class path");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    /**
     * Reports every violation of the schema.
     *
     * @return whether the document can be checked any further: nothing is too long, and every wrong
     *     value was reported
     */
    public boolean admits(Document document) {
        if (!Sizes.areKept(schema.getSchemaNode(), document)) {
            return false;
        }
        validate(document);
        return !document.hasUntold();
    }

    private void validate(Document document) {
        List<Error> errors =
                schema.validate(
                        document.root(),
                        context ->
                                context.executionConfig(config -> config.locale(Locale.ENGLISH)));
        // Ignores values that could not be read: they were reported, and something else stands in
        // their place.
        Set<String> unread = document.faults();
        for (Error error : errors) {
            if (unread.isEmpty() || !unread.contains(pointer(error))) {
                document.error(() -> pointer(error), () -> fault(error));
            }
        }
    }

    /**
     * The value at fault; for an unknown member it is the member itself, to which the library does
     * not point.
     */
    private static String pointer(Error error) {
        String pointer = pointer(error.getInstanceLocation());
        return error.getKeyword().equals("additionalProperties")
                ? Pointer.member(pointer, error.getProperty())
                : pointer;
    }

    private static String pointer(NodePath path) {
        String pointer = "";
        for (int i = 0; i < path.getNameCount(); i++) {
            pointer = Pointer.member(pointer, path.getName(i));
        }
        return pointer;
    }

    private Fault fault(Error error) {
        JsonNode rule = error.getSchemaNode();
        return switch (error.getKeyword()) {
            case "required" ->
                    Fault.of("schema.required", "\"%s\" is missing", error.getProperty());
            case "additionalProperties" -> unknown(error);
            case "enum" -> notListed(error);
            case "const" -> Fault.of("schema.other", "must be %2$s, was %1$s", value(error), rule);
            case "type" ->
                    Fault.of(
                            "schema.other",
                            "must be %2$s, was %1$s",
                            value(error),
                            article(rule.asString()));
            case "minimum" ->
                    Fault.of("schema.least", "must be %s or more, was %s", rule, value(error));
            case "maximum" ->
                    Fault.of("schema.most", "must be %s or less, was %s", rule, value(error));
            case "exclusiveMinimum" ->
                    Fault.of("schema.above", "must be more than %s, was %s", rule, value(error));
            default -> Fault.of("schema", "%s", error.getMessage());
        };
    }

    private Fault unknown(Error error) {
        String object = pointer(error.getSchemaLocation().getFragment().getParent());
        Collection<String> known =
                schema.getSchemaNode().at(object + "/properties").propertyNames();
        String name = error.getProperty();
        return Fault.of(
                "schema.unknown",
                "%s is not known here%s",
                Escape.quoted(name),
                Suggestion.among(known, name));
    }

    private static Fault notListed(Error error) {
        List<String> known =
                StreamSupport.stream(error.getSchemaNode().spliterator(), false)
                        .map(JsonNode::asString)
                        .toList();
        return Fault.of(
                "schema.unknown",
                "%s is not one of %s%s",
                value(error),
                Suggestion.list(known),
                Suggestion.among(known, error.getInstanceNode().asString("")));
    }

    private static String value(Error error) {
        return Escape.shown(error.getInstanceNode());
    }

    private static String article(String type) {
        return switch (type) {
            case "array" -> "a list";
            case "object", "integer" -> "an " + type;
            default -> "a " + type;
        };
    }
}
