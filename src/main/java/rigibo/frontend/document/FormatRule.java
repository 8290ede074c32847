package rigibo.frontend.document;

import tools.jackson.databind.JsonNode;

/** Rejects a file of an unknown format; further messages about it would mislead. */
public final class FormatRule {

    /** Formats that there may ever be; a larger number is damage. */
    private static final int LAST = 999;

    private FormatRule() {}

    /** Whether a file is of a later format than the one known; then a problem says so. */
    public static boolean isNewer(Document document, int known) {
        String pointer = "/format";
        JsonNode format = document.node(pointer);
        boolean isNewer = format.isInt() && format.intValue() > known && format.intValue() <= LAST;
        if (isNewer) {
            document.error(
                    pointer,
                    () ->
                            "made for a newer RigiBo (format "
                                    + format
                                    + "); this version reads "
                                    + known);
        }
        return isNewer;
    }
}
