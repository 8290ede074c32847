package rigibo.frontend.document;

import tools.jackson.core.StreamReadConstraints;

/** Limits on the size of a file; larger ones are not files of the game. */
final class Bounds {

    /**
     * Most bytes of a file. A level of 500 bodies has about 100 kB; a much larger file is something
     * else.
     */
    static final int BYTES = 1_000_000;

    /** Most levels of nested lists and objects; a draft's level has 7. */
    private static final int DEPTH = 32;

    /** Most names, values and brackets; 500 polygons of 16 corners each have half as many. */
    private static final int TOKENS = 100_000;

    /**
     * Most characters of a text; the longest is the path of a draft's file, up to 4096 under Linux.
     */
    private static final int TEXT = 5_000;

    /** Most characters of a name; a level's id has up to 40. */
    private static final int NAME = 200;

    /**
     * Most characters of a number; a double with all its binary digits may take a few more than 20.
     */
    static final int NUMBER = 100;

    /**
     * Largest magnitude of a number. Up to it doubles represent every integer (I-JSON, RFC 7493,
     * 2.2), and the schema's validator throws for larger ones.
     */
    static final double LARGEST = 0x1p53;

    static final StreamReadConstraints OF_PARSER =
            StreamReadConstraints.builder()
                    .maxDocumentLength(BYTES)
                    .maxNestingDepth(DEPTH)
                    .maxTokenCount(TOKENS)
                    .maxStringLength(TEXT)
                    .maxNameLength(NAME)
                    .maxNumberLength(NUMBER)
                    .build();

    private Bounds() {}
}
