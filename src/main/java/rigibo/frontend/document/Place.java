package rigibo.frontend.document;

import tools.jackson.core.TokenStreamLocation;

/**
 * A position in a file.
 *
 * @param line from 1
 * @param column in characters, from 1
 */
public record Place(int line, int column) {

    /** The first character. */
    static final Place START = new Place(1, 1);

    static Place of(TokenStreamLocation location) {
        return new Place(Math.max(1, location.getLineNr()), Math.max(1, location.getColumnNr()));
    }

    @Override
    public String toString() {
        return line + ":" + column;
    }
}
