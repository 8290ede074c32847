package rigibo.frontend.document;

import tools.jackson.core.StreamReadConstraints;

/** Limits on the size of a file; larger ones are not files of the game. */
final class Bounds {

    /** A level of 500 bodies takes about 100 kB; far above it a file is something else. */
    static final int BYTES = 1_000_000;

    /** Lists and objects within each other; a draft's level has 7. */
    private static final int DEPTH = 32;

    /** Names, values and brackets; 500 polygons of 16 corners each have half of it. */
    private static final int TOKENS = 100_000;

    /** Characters of a text; the longest is the path of a draft's file, of 4096 under Linux. */
    private static final int TEXT = 5_000;

    /** Characters of a name; a level's id has 40. */
    private static final int NAME = 200;

    /** Characters of a number; a double to its last binary digit may have a few more than 20. */
    static final int NUMBER = 100;

    /**
     * Largest number, either way: up to it a double counts in ones (I-JSON, RFC 7493, 2.2). The
     * schema's validator throws at larger ones.
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
