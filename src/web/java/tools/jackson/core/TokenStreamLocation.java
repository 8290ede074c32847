package tools.jackson.core;

/** A place in a text: line and column from 1. */
public final class TokenStreamLocation {

    private final int line;
    private final int column;

    TokenStreamLocation(int line, int column) {
        this.line = line;
        this.column = column;
    }

    public int getLineNr() {
        return line;
    }

    public int getColumnNr() {
        return column;
    }
}
