package rigibo.frontend.document;

import java.util.Locale;

/**
 * Why a file cannot be used, in words for players; authors read the exact message of the problem.
 */
public enum Cause {
    /** Something in it is not as it must be. */
    CONTENT,
    /** It is not there, or this system does not let it be read. */
    UNREADABLE,
    /** It is larger than whatever is read. */
    TOO_LARGE,
    /** A part of it is missing or was changed, or it is something else altogether. */
    DAMAGED,
    /** It states a later format. */
    NEWER,
    /** It is a folder or a zip file without anything to open. */
    EMPTY,
    /** It is a run of a level that is not here. */
    LEVEL_UNKNOWN,
    /** It is a run of a level that was changed since. */
    LEVEL_CHANGED,
    /** It is from a version in which bodies move otherwise, or other levels are made. */
    OTHER_VERSION;

    /** Key of its sentence in the bundles. */
    public String key() {
        return "problem." + name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
