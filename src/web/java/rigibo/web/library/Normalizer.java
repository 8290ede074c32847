package rigibo.web.library;

/** Forms of texts in which letters and their marks are one character, or several. */
public final class Normalizer {

    private Normalizer() {}

    /** A form, by the name that browsers have for it. */
    public enum Form {
        NFC,
        NFD,
        NFKC,
        NFKD
    }
}
