package rigibo.lab.bench.large;

/**
 * The costs of one very large world; processor times are in ns.
 *
 * @param bodies movable bodies of it
 * @param add a body added
 * @param first the first step
 * @param step a later step, the median
 * @param most the slowest of them
 * @param ask a query for the body at a point
 * @param snapshot a snapshot
 * @param remove a body removed
 * @param asleep a step of as many bodies in heaps, all of them asleep
 * @param bytes of memory for each body, with its contacts
 */
record LargeCosts(
        int bodies,
        double add,
        double first,
        double step,
        double most,
        double ask,
        double snapshot,
        double remove,
        double asleep,
        double bytes) {}
