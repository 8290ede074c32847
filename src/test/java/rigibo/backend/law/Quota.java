package rigibo.backend.law;

/**
 * How often a law has to be asked over all its scenes, for what is never asked always holds.
 *
 * @param least occasions to break the law; about half of those counted when the law was written, so
 *     that a change of the engine's last digits, which changes what becomes of a scene, keeps it
 * @param what one occasion is, in the plural
 */
record Quota(long least, String what) {

    Quota {
        if (least < 1) {
            throw new IllegalArgumentException("a law that need not be asked: " + least);
        }
    }
}
