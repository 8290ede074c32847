package rigibo.backend.saved;

/** Mixes 64-bit words into a 64-bit hash. */
final class Bits {

    /** Initial value of a hash. */
    static final long SEED = 0x243F6A8885A308D3L;

    private static final long ODD = 0x9E3779B97F4A7C15L;

    private Bits() {}

    /**
     * Multiplies and rotates, as in the finalizers of the splittable generators (Steele et al.
     * 2014). It is one to one in the hash and in the word, so that a single differing word always
     * gives a different hash.
     */
    static long fold(long hash, long word) {
        long mixed = Long.rotateLeft(hash ^ word, 27) * ODD;
        return mixed ^ mixed >>> 29;
    }
}
