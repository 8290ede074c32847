package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Pose;

/** The gap along an axis that is fixed in the world. */
final class FixedAxisGap implements GapAlong {

    private final AxisReach reachA = new AxisReach();
    private final AxisReach reachB = new AxisReach();

    /**
     * Fixes the axis, a unit vector from A to B, at the time of two poses. Positions are relative
     * to A's start, so that no digits are lost far from the origin.
     */
    void fix(Motion a, Pose poseA, Motion b, Pose poseB, double x, double y) {
        reachA.fix(a, poseA, x, y, a.x, a.y);
        reachB.fix(b, poseB, -x, -y, a.x, a.y);
    }

    @Override
    public double at(double time) {
        return -(reachA.at(time) + reachB.at(time));
    }

    @Override
    public double bend(double from, double to) {
        return Math.max(0, reachA.bend(from, to) + reachB.bend(from, to));
    }
}
