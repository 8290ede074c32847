package rigibo.frontend.save;

import rigibo.frontend.document.Value;

import tools.jackson.databind.node.ObjectNode;

/** The form of a value in JSON. */
interface Format<T> {

    /** What there is where there is no file. */
    T initial();

    /**
     * The value of a JSON object of this format or an older one. What is missing or of another kind
     * is told, and something else stands in its place.
     */
    T read(Value json);

    /** Tells a value in an empty object. */
    void write(T value, ObjectNode json);

    /**
     * Both what is on disk by now, by another game that runs, and what is to be written.
     *
     * @param before what this game read or wrote last, from which its own value comes
     */
    T merged(T before, T onDisk, T own);
}
