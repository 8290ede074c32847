package rigibo.frontend.puzzle.rules;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Length;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.puzzle.level.Steps;

/** Detects that everything has come to rest, whether sleep is declared or not. */
final class RestWatch {

    /** Fastest motion that counts as rest, m/s: a hand's breadth in ten seconds. */
    private static final double STILL = 0.01;

    /**
     * Time for which all bodies must be still, since a body at the top of its swing is still for a
     * moment.
     */
    private static final int LONG_ENOUGH = Steps.of(1);

    private int stillSteps;

    RestWatch copy() {
        RestWatch copy = new RestWatch();
        copy.stillSteps = stillSteps;
        return copy;
    }

    /** Call after each step. */
    void observe(Board board) {
        boolean isStill = true;
        for (RigidBody body : board.pool().bodies()) {
            isStill &= isStill(body);
        }
        stillSteps = isStill ? stillSteps + 1 : 0;
    }

    /** Starts again after a click, which moves bodies in the next step at the earliest. */
    void restart() {
        stillSteps = 0;
    }

    int stillSteps() {
        return stillSteps;
    }

    boolean isAtRest() {
        return stillSteps >= LONG_ENOUGH;
    }

    private static boolean isStill(RigidBody body) {
        if (body.type() != BodyType.DYNAMIC || !body.isAwake()) {
            return true;
        }
        double rim = Math.abs(body.angularVelocity()) * body.shape().boundingRadius();
        return Length.hypot(body.velocityX(), body.velocityY()) + rim < STILL;
    }
}
