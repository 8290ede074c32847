package rigibo.frontend.save;

import rigibo.frontend.document.Value;

import tools.jackson.databind.node.ObjectNode;

/** The form of a value in JSON. */
interface Format<T> {

    /** The value where there is no file. */
    T initial();

    /**
     * The value of a JSON object of this format or an older one. A member that is missing or of
     * another type is reported and replaced by a default.
     */
    T read(Value json);

    /** Tells a value in an empty object. */
    void write(T value, ObjectNode json);

    /**
     * Merges the value to be written with the one that another running game has put on the disk.
     *
     * @param before the value that this game read or wrote last
     */
    T merged(T before, T onDisk, T own);
}
