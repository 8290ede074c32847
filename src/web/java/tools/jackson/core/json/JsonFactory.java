package tools.jackson.core.json;

import tools.jackson.core.JsonParser;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;

/** Makes readers. */
public final class JsonFactory {

    private final StreamReadConstraints bounds;

    JsonFactory(StreamReadConstraints bounds) {
        this.bounds = bounds;
    }

    public static JsonFactoryBuilder builder() {
        return new JsonFactoryBuilder();
    }

    public JsonParser createParser(ObjectReadContext context, String text) {
        return new JsonParser(text, bounds);
    }
}
