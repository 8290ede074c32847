package rigibo.fuzz.judge;

import static rigibo.fuzz.judge.LawBroken.unless;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;

import java.util.List;
import java.util.Optional;

/**
 * Compares answers with a search through all discs and sharp polygons, except where round-off
 * decides.
 */
final class Answers {

    private static final String AT = "bodyAt is the last added of those at the point";
    private static final String IN = "overlapping tells of all that reach into the box";

    private Answers() {}

    static void requireAt(Pool pool, double x, double y, Optional<RigidBody> found) {
        List<RigidBody> bodies = pool.bodies();
        int place = found.map(bodies::indexOf).orElse(-1);
        for (int i = 0; i < bodies.size(); i++) {
            if (!Outline.isKnown(bodies.get(i))) {
                continue;
            }
            Outline outline = new Outline(bodies.get(i));
            double depth = outline.depth(x, y);
            double slack = outline.slack(x, y);
            unless(
                    !(depth > slack && i > place),
                    AT,
                    "(%s, %s) is %s m inside %s, found is %s",
                    x,
                    y,
                    depth,
                    bodies.get(i),
                    found);
            unless(
                    !(i == place && depth < -slack),
                    AT,
                    "(%s, %s) is %s m outside %s, which is found",
                    x,
                    y,
                    -depth,
                    bodies.get(i));
        }
    }

    static void requireIn(Pool pool, Aabb box, List<RigidBody> found) {
        unless(found.stream().distinct().count() == found.size(), IN, "twice in %s", found);
        for (RigidBody body : pool.bodies()) {
            if (!Outline.isKnown(body)) {
                continue;
            }
            Outline outline = new Outline(body);
            double overlap = outline.overlap(box);
            double slack = outline.slack(box.minX, box.minY, box.maxX, box.maxY);
            boolean isFound = found.contains(body);
            unless(isFound || !(overlap > slack), IN, "%s is in by %s m", body, overlap);
            unless(!isFound || !(overlap < -slack), IN, "%s is %s m away", body, -overlap);
        }
    }
}
