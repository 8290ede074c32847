package rigibo.backend.storage;

/**
 * By how much arrays grow that are full: small ones to twice their length, so that they are seldom
 * copied, and large ones by a quarter, so that at most a fifth of them is unused. Each entry of a
 * large one is then copied five times in the mean, in place of twice.
 */
public final class Growth {

    /** Length from which on an array counts as large. */
    public static final int LARGE = 65_536;

    private Growth() {}

    /** The length that follows on one. */
    public static int after(int length) {
        return length < LARGE ? 2 * length : length + length / 4;
    }
}
