package rigibo.frontend.save;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** How something is told in JSON. */
interface Format<T> {

    /** What there is where there is no file. */
    T initial();

    /**
     * The value of a JSON object of this format or an older one.
     *
     * @throws tools.jackson.core.JacksonException when something is missing or of another kind
     * @throws IllegalArgumentException when a number or a word cannot be
     */
    T read(JsonNode json);

    /** Tells a value in an empty object. */
    void write(T value, ObjectNode json);

    /**
     * Both what is on disk by now, by another game that runs, and what is to be written.
     *
     * @param before what this game read or wrote last, from which its own value comes
     */
    T merged(T before, T onDisk, T own);
}
