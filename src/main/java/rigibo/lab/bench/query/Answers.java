package rigibo.lab.bench.query;

/**
 * The measurements of a process.
 *
 * @param nanos by {@link Rays}: processor time of a ray, ns, the median of all runs
 * @param met by {@link Rays}: share of their length that rays go on average, to check that engines
 *     agree
 * @param sensing time that sensors add to a step, ns; 0 if it was not measured
 */
record Answers(double[] nanos, double[] met, double sensing) {}
