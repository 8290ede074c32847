package rigibo.fuzz.judge;

/** Thrown if a law does not hold. */
final class LawBroken extends RuntimeException {

    private static final long serialVersionUID = 1;

    /** The law, in a few words that are the same each time. */
    final String law;

    LawBroken(String law, String words) {
        super(words);
        this.law = law;
    }

    LawBroken(String law, String words, Throwable cause) {
        super(words, cause);
        this.law = law;
    }

    /** Throws if a law does not hold. */
    static void unless(boolean holds, String law, String words, Object... arguments) {
        if (!holds) {
            throw new LawBroken(law, String.format(words, arguments));
        }
    }
}
