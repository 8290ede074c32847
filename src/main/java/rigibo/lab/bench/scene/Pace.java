package rigibo.lab.bench.scene;

/**
 * Which steps of a scene are timed.
 *
 * @param rehearsal s for which the scene is run in other worlds before, so that what is timed is
 *     compiled: needed where few steps come before the timed ones
 * @param settling steps of the timed world that are not timed
 * @param timed steps after them
 */
public record Pace(double rehearsal, int settling, int timed) {

    /**
     * As told by {@link #words}.
     *
     * @throws NumberFormatException when it is not
     */
    public static Pace parse(String words) {
        String[] number = words.split(",");
        return new Pace(
                Double.parseDouble(number[0]),
                Integer.parseInt(number[1]),
                Integer.parseInt(number[2]));
    }

    /** As told on a command line. */
    public String words() {
        return rehearsal + "," + settling + "," + timed;
    }

    /** The same with so many timed steps, and no more than that before them. */
    public Pace timing(int steps) {
        return new Pace(rehearsal, Math.min(settling, steps), steps);
    }
}
