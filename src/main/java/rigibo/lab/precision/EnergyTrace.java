package rigibo.lab.precision;

/**
 * The sampled energy of a run, as shares of the initial energy.
 *
 * @param engine name
 * @param setting name
 * @param seconds when
 * @param energy that was there
 * @param byDesign that should be there: what is missing to 1 was lost by design
 * @param drift how far the first is from the second, where an impact that comes early or late by
 *     less than a step is no drift
 */
record EnergyTrace(
        String engine,
        String setting,
        double[] seconds,
        double[] energy,
        double[] byDesign,
        double[] drift) {

    /** The largest drift. */
    double most() {
        double most = 0;
        for (double one : drift) {
            most = Math.max(most, one);
        }
        return most;
    }
}
