package rigibo.backend.contact.joint;

/**
 * Rods and ropes that pull so hard that the bodies between them swing faster than kicks follow. A
 * line of length l that pulls with F draws its ends back across by F/l per metre that they leave
 * it. With the places at the end of a drift of h seconds, that is a damper of h·F/l across the line
 * (the geometric stiffness of a distance: M. Tournier, M. Nesme, B. Gilles and F. Faure, Stable
 * constrained dynamics, 2015). Such a damper would soon stop a pendulum, too. Most of the motion
 * before the kick is therefore kept: with all of it, the damper is a mass of L·h·F/l that is added
 * across the line in a kick of L seconds, and takes no energy.
 */
final class TautLines {

    private final PackedJoints packed;

    /** Length of the last kick, s; 0 where kicks follow. */
    private double kicked;

    /** Share of the motion before the present kick that is kept. */
    private double kept;

    TautLines(PackedJoints packed) {
        this.packed = packed;
    }

    /** Begins with rows of an island whose kicks follow its lines. */
    void rest() {
        kicked = 0;
    }

    /**
     * Begins with rows of an island whose last kick lasted {@code lastKick} seconds, of whose
     * motion a share is kept.
     */
    void begin(double lastKick, double share) {
        kicked = lastKick;
        kept = share;
    }

    /** Share of the motion before the present kick, relative to which a body is drawn back. */
    double kept() {
        return kept;
    }

    /** Force with which a line pulled in the last kick, N; 0 where kicks follow. */
    double pull(int joint) {
        if (kicked == 0) {
            return 0;
        }
        double rod = -packed.impulseOf(joint, JointRows.X);
        double rope = packed.impulseOf(joint, JointRows.UPPER);
        return Math.max(0, (rod + rope) / kicked);
    }

    /**
     * Compliance of a row across a line of a length in m that pulls with a force in N, in a kick
     * and a drift of the given lengths, s; 1/kg.
     */
    static double give(double force, double length, double kick, double drift) {
        return length / (kick * drift * force);
    }
}
