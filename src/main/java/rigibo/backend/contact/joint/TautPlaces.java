package rigibo.backend.contact.joint;

/**
 * How joints hold their places in an island as long as its span. A straight row of links carries a
 * load across it by no finite force, and closing the hinges of one that sags would lift it without
 * a force. So joints give way there as stiff springs. Where n links of length l carry a load F and
 * their hinges open by e each, the row is longer by n·e and sags by s, with s² = n·l·n·e/2. Its
 * tension F·n·l/4s = F·√(l/8e) does not depend on n. The stiffness is the one at which e is a small
 * share of the tolerance.
 *
 * <p>A damper beside each spring lets errors decay rather than swing. Springs without it would
 * throw a load back that fell onto the row.
 */
final class TautPlaces {

    /**
     * Error under the load across, as a share of the tolerance, m per metre of the joint's arms.
     */
    private static final double KEPT = 0.1;

    /** Time in which an error decays to 1/e of itself, s. */
    private static final double DECAY = 0.5;

    /**
     * Least square of the phase of a spring in a substep, rad², so that it is stiff where no force
     * acts across the row.
     */
    private static final double STIFF = 1e3;

    private final NeutralRows rows;

    /** Stiffness of a joint times its size, N. */
    private double strength;

    private boolean isTaut;

    TautPlaces(NeutralRows rows) {
        this.rows = rows;
    }

    /** Whether the rows that are being written are those of a taut island. */
    boolean areTaut() {
        return isTaut;
    }

    /** Begins with rows of an island that is not taut. */
    void rest() {
        isTaut = false;
    }

    /** Begins with rows of a taut island whose bodies carry a sum of loads, N. */
    void begin(double loads, double tolerance) {
        isTaut = true;
        double kept = KEPT * tolerance;
        strength = loads / (kept * Math.sqrt(8 * kept));
    }

    /**
     * Lets a finished equation give way, which misses its place by some metres or radians; angles
     * only decay.
     *
     * @param size size of the joint, m
     * @param kick length of the kick, s
     * @param drift length of the drift after it, s
     */
    void giveWay(int row, double missed, double size, double kick, double drift) {
        double time = drift + DECAY;
        rows.target[row] = -missed / time;
        if (rows.unit[row] == 1) {
            double least = STIFF / (drift * drift * rows.response[row]);
            rows.give[row] = 1 / (kick * time * Math.max(strength / size, least));
        }
    }

    /** Speed at which a limit that is passed by some metres or radians comes back. */
    double back(double passed, double drift) {
        return passed / (drift + DECAY);
    }
}
