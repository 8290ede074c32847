package rigibo.lab.bench.query;

/**
 * What a process found.
 *
 * @param nanos by {@link Rays}: processor time of a ray, ns, the median of all runs
 * @param met by {@link Rays}: share of the way that rays go on average, by which engines are
 *     compared
 * @param sensing what sensors add to a step, ns; 0 where that was not asked
 */
record Answers(double[] nanos, double[] met, double sensing) {}
