package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Slope;

/** A body on a slope of its own material. */
final class Descent {

    final RigidBody body;
    private final Slope slope;
    private final double startX;
    private final double startY;

    /** Adds the slope and the body, which is placed on it. */
    Descent(WatchedPool pool, Slope slope, BodyDefinition placed) {
        this.slope = slope;
        pool.add(slope.plank(placed.material()));
        body = pool.add(placed);
        startX = body.x();
        startY = body.y();
    }

    /** The place along the slope, m. */
    double place() {
        return slope.down(body.x(), body.y());
    }

    /** The distance down the slope since the start, m. */
    double way() {
        return slope.down(body.x() - startX, body.y() - startY);
    }

    /** The speed down the slope, m/s. */
    double speed() {
        return slope.down(body.velocityX(), body.velocityY());
    }
}
