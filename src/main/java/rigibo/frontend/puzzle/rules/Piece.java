package rigibo.frontend.puzzle.rules;

import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.Verb;

import java.util.Optional;

/**
 * A body of the level in play.
 *
 * @param definition as the level states it
 * @param body its handle; no longer alive once it was deleted or fell out of the world
 */
public record Piece(LevelBody definition, RigidBody body) implements Target {

    @Override
    public String id() {
        return definition.id();
    }

    @Override
    public Optional<Verb> verb() {
        return definition.verb();
    }

    @Override
    public boolean isAlive() {
        return body.isAlive();
    }

    @Override
    public double x() {
        return body.x();
    }

    @Override
    public double y() {
        return body.y();
    }
}
