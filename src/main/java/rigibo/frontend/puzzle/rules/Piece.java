package rigibo.frontend.puzzle.rules;

import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.level.LevelBody;

/**
 * A body of the level in play.
 *
 * @param definition as the level states it
 * @param body its handle; no longer alive once it was deleted or fell out of the world
 */
public record Piece(LevelBody definition, RigidBody body) {

    /** Whether a click would delete it. */
    public boolean isDeletable() {
        return body.isAlive() && definition.deletable();
    }
}
