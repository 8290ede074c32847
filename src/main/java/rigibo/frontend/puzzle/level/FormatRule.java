package rigibo.frontend.puzzle.level;

import tools.jackson.databind.JsonNode;

/** A file of a format that this version does not know; whatever else it says would mislead. */
public final class FormatRule {

    private FormatRule() {}

    /** Whether a file is of a later format than the one known; then a problem says so. */
    public static boolean isNewer(LocatedJson json, int known, Problems problems) {
        String pointer = "/format";
        JsonNode format = json.node(pointer);
        boolean isNewer = format.isInt() && format.asInt() > known;
        if (isNewer) {
            problems.error(
                    json.at(pointer),
                    pointer,
                    "made for a newer RigiBo (format "
                            + format.asInt()
                            + "); this version reads "
                            + known);
        }
        return isNewer;
    }
}
