package tools.jackson.core.json;

import tools.jackson.core.TSFBuilder;

/** Builds factories of readers. */
public final class JsonFactoryBuilder extends TSFBuilder<JsonFactory, JsonFactoryBuilder> {

    public JsonFactory build() {
        return new JsonFactory(bounds);
    }
}
