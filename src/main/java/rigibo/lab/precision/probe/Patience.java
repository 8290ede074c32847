package rigibo.lab.precision.probe;

/**
 * The time that a process may spend on all its settings together.
 *
 * @param warmMillis least time for warming up, after errors were computed and before anything is
 *     timed
 * @param timedMillis least time that is timed
 * @param repeats least number of repeats of each setting, unless they would take too long
 * @param mostMillis time after which no further repeat begins
 */
public record Patience(double warmMillis, double timedMillis, int repeats, double mostMillis) {

    /** Errors only. */
    public static final Patience NONE = new Patience(0, 0, 0, 0);

    /** Times the steps of the run that finds the errors, which takes minutes. */
    public static final Patience ONE_RUN = new Patience(0, 0, 1, 0);

    /** Its words on a command line. */
    public String words() {
        return warmMillis + "," + timedMillis + "," + repeats + "," + mostMillis;
    }

    static Patience parse(String words) {
        String[] number = words.split(",");
        return new Patience(
                Double.parseDouble(number[0]),
                Double.parseDouble(number[1]),
                Integer.parseInt(number[2]),
                Double.parseDouble(number[3]));
    }
}
