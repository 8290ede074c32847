package rigibo.frontend.puzzle.level;

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
import java.util.stream.StreamSupport;

/** Compares a file with its JSON schema and words what differs. */
public final class JsonSchema {

    private final Schema schema;

    /** The schema of a name among the class path's resources. */
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

    /** Tells everything that the schema forbids. */
    public void check(LocatedJson json, Problems problems) {
        List<Error> errors =
                schema.validate(
                        json.root(),
                        context ->
                                context.executionConfig(config -> config.locale(Locale.ENGLISH)));
        for (Error error : errors) {
            String pointer = pointer(error);
            problems.error(json.at(pointer), pointer, sentence(error));
        }
    }

    /**
     * The value at fault; for an unknown member that member, which the library does not point at.
     */
    private static String pointer(Error error) {
        String pointer = pointer(error.getInstanceLocation());
        return error.getKeyword().equals("additionalProperties")
                ? JsonParsing.member(pointer, error.getProperty())
                : pointer;
    }

    private static String pointer(NodePath path) {
        String pointer = "";
        for (int i = 0; i < path.getNameCount(); i++) {
            pointer = JsonParsing.member(pointer, path.getName(i));
        }
        return pointer;
    }

    private String sentence(Error error) {
        return switch (error.getKeyword()) {
            case "required" -> "\"" + error.getProperty() + "\" is missing";
            case "additionalProperties" -> unknown(error);
            case "enum" -> notListed(error);
            case "const" -> "must be " + error.getSchemaNode() + ", was " + error.getInstanceNode();
            case "type" ->
                    "must be "
                            + article(error.getSchemaNode().asString())
                            + ", was "
                            + shown(error.getInstanceNode());
            case "minimum" -> "must be " + error.getSchemaNode() + " or more, was " + value(error);
            case "maximum" -> "must be " + error.getSchemaNode() + " or less, was " + value(error);
            case "exclusiveMinimum" ->
                    "must be more than " + error.getSchemaNode() + ", was " + value(error);
            default -> error.getMessage();
        };
    }

    private String unknown(Error error) {
        String object = pointer(error.getSchemaLocation().getFragment().getParent());
        Collection<String> known =
                schema.getSchemaNode().at(object + "/properties").propertyNames();
        String name = error.getProperty();
        return "\"" + name + "\" is not known here" + Suggestion.among(known, name);
    }

    private static String notListed(Error error) {
        List<String> known =
                StreamSupport.stream(error.getSchemaNode().spliterator(), false)
                        .map(JsonNode::asString)
                        .toList();
        String word = shown(error.getInstanceNode());
        return word
                + " is not one of "
                + Suggestion.list(known)
                + Suggestion.among(known, error.getInstanceNode().asString(""));
    }

    private static String value(Error error) {
        return shown(error.getInstanceNode());
    }

    private static String shown(JsonNode node) {
        return switch (node.getNodeType()) {
            case OBJECT -> "an object";
            case ARRAY -> "a list";
            case STRING, NUMBER, BOOLEAN, NULL, BINARY, MISSING, POJO -> node.toString();
        };
    }

    private static String article(String type) {
        return switch (type) {
            case "array" -> "a list";
            case "object", "integer" -> "an " + type;
            default -> "a " + type;
        };
    }
}
