package rigibo.frontend.puzzle.rules;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Length;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.LevelPath;
import rigibo.frontend.puzzle.level.Steps;

import java.util.ArrayList;
import java.util.List;

/**
 * Drives a body along its path. Its position follows from the number of steps alone, so that a
 * replayed run is the same; each leg takes a whole number of steps.
 */
final class Ride {

    private final RigidBody body;
    private final LevelPath path;
    private final double angle;

    /** The start and the stops. */
    private final List<LevelPath.Stop> places = new ArrayList<>();

    private final int pause;

    /**
     * The stop at which it is or from which it comes, and whether the next stop is after or before
     * that one.
     */
    private int at;

    private int direction = 1;

    /** The step before which it departs. */
    private int leaves;

    Ride(LevelBody definition, RigidBody body) {
        this.body = body;
        path = definition.path().orElseThrow();
        angle = definition.angle();
        places.add(new LevelPath.Stop(definition.x(), definition.y()));
        places.addAll(path.stops());
        pause = Steps.of(path.pause());
        leaves = pause;
    }

    /** Must be called before each step, with the number of steps made. */
    void beforeStep(int done) {
        if (done == leaves && body.isAlive()) {
            leave(done);
        }
    }

    private void leave(int done) {
        LevelPath.Stop from = places.get(at);
        at = next();
        LevelPath.Stop to = places.get(at);
        double metres = Length.hypot(to.x() - from.x(), to.y() - from.y());
        int steps = Math.max(1, Steps.of(metres / path.speed()));
        body.driveTo(to.x(), to.y(), angle, Steps.seconds(steps));
        boolean staysThere = path.end() == LevelPath.End.STAY && at == places.size() - 1;
        leaves = staysThere ? Integer.MAX_VALUE : done + steps + pause;
    }

    private int next() {
        boolean isLast = at + direction < 0 || at + direction == places.size();
        if (isLast && path.end() == LevelPath.End.ROUND) {
            return 0;
        }
        direction = isLast ? -direction : direction;
        return at + direction;
    }
}
