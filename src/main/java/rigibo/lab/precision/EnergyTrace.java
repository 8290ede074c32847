package rigibo.lab.precision;

/**
 * The sampled energy of a run, as shares of the initial energy.
 *
 * @param engine name
 * @param setting name
 * @param seconds times of the samples
 * @param energy measured energy
 * @param byDesign energy that should be left: the rest to 1 is lost by design
 * @param drift difference of the two; an impact that comes early or late by less than a step is no
 *     drift
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
