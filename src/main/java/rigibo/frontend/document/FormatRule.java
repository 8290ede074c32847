package rigibo.frontend.document;

import tools.jackson.databind.JsonNode;

/** Rejects a file of an unknown format; further messages about it would mislead. */
public final class FormatRule {

    /** Largest format number that is believed; a larger number is damage. */
    private static final int LAST = 999;

    private FormatRule() {}

    /** Whether a file has a later format than the known one; if so, reports it. */
    public static boolean isNewer(Document document, int known) {
        String pointer = "/format";
        JsonNode format = document.node(pointer);
        boolean isNewer = format.isInt() && format.intValue() > known && format.intValue() <= LAST;
        if (isNewer) {
            document.error(
                    Cause.NEWER,
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
