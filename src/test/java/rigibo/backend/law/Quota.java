package rigibo.backend.law;

/**
 * How often a law has to be asked over all its seeds, for what is never asked always holds.
 *
 * @param least occasions to break the law; about half of those counted when the law was written, so
 *     that a change of the engine's last digits, which changes what becomes of a scene, keeps it
 * @param what one occasion is, in the plural
 */
record Quota(long least, String what) {

    /** The share of the occasions that falls to the seeds that are asked. */
    long leastOf(Seeds seeds) {
        int all = seeds.all().size();
        return Math.max(1, least * seeds.asked().size() / all);
    }

    Quota {
        if (least < 1) {
            throw new IllegalArgumentException("a law that need not be asked: " + least);
        }
    }
}
