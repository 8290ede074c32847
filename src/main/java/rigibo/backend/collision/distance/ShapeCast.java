package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.setup.ImpactSearch;
import rigibo.backend.storage.RoundOff;

/**
 * The time at which an outline that moves in a straight line, without turning, meets another one at
 * rest. An edge of a chain counts as a line that is met from the air only; from the matter a body
 * passes it. Uses scratch fields, so each thread needs its own instance.
 */
public final class ShapeCast {

    /** Gap left at the meeting, as a share of the narrower one's width. */
    private static final double TOLERANCE = 1e-9;

    /** Half the thickness of the line, as a share of its length. */
    private static final double THIN = 1e-10;

    private final TimeOfImpact search = new TimeOfImpact();
    private final Distance distance = new Distance();
    private final Pose pose = new Pose();
    private final Pose otherPose = new Pose();

    /**
     * The first time, from 0 on, at which two motions without turning meet, or {@link
     * TimeOfImpact#NEVER}.
     */
    public double find(Motion one, Motion other, double until) {
        Outline outline = one.outline;
        Outline otherOutline = other.outline;
        one.outline = solid(outline);
        other.outline = solid(otherOutline);
        double time = search.find(one, other, 0, until, TOLERANCE, ImpactSearch.ITP);
        if (time <= until && (outline.isEdge() || otherOutline.isEdge())) {
            one.poseAt(time, pose);
            other.poseAt(time, otherPose);
            distance.measure(one.outline, pose, other.outline, otherPose);
            boolean isFromAir =
                    isInFront(outline, pose, distance.axisX, distance.axisY)
                            && isInFront(otherOutline, otherPose, -distance.axisX, -distance.axisY);
            time = isFromAir ? time : TimeOfImpact.NEVER;
        }
        one.outline = outline;
        other.outline = otherOutline;
        return time;
    }

    private static Outline solid(Outline outline) {
        return outline.isEdge() ? outline.asLine(THIN) : outline;
    }

    /** Whether an axis away from an outline does not come from the matter of an edge. */
    private static boolean isInFront(Outline outline, Pose at, double axisX, double axisY) {
        if (!outline.isEdge()) {
            return true;
        }
        double x = at.cos * outline.normalX(0) - at.sin * outline.normalY(0);
        double y = at.sin * outline.normalX(0) + at.cos * outline.normalY(0);
        return axisX * x + axisY * y >= -RoundOff.OF_PLACES;
    }
}
