package rigibo.lab.bench.scene;

/**
 * Which steps of a scene are timed.
 *
 * @param rehearsal time for which the scene runs in other worlds first, s, so that the timed code
 *     is compiled; needed where few steps come before the timed ones
 * @param settling steps of the timed world that are not timed
 * @param timed steps after them
 */
public record Pace(double rehearsal, int settling, int timed) {

    /**
     * Parses the words of {@link #words}.
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

    /** The pace as an argument of a process. */
    public String words() {
        return rehearsal + "," + settling + "," + timed;
    }

    /** A copy with another number of timed steps, and at most as many settling steps. */
    public Pace timing(int steps) {
        return new Pace(rehearsal, Math.min(settling, steps), steps);
    }
}
