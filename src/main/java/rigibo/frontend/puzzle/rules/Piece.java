package rigibo.frontend.puzzle.rules;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.level.Verb;

import java.util.Optional;

/** A body of the level in play. */
public final class Piece implements Target {

    private final LevelBody definition;
    private final RigidBody body;
    private boolean isOn;
    private boolean isFrozen;
    private Optional<Fuse> fuse = Optional.empty();
    private Optional<Melt> melt = Optional.empty();

    Piece(LevelBody definition, RigidBody body) {
        this.definition = definition;
        this.body = body;
        isOn = !definition.handling().beginsOff();
    }

    /** The level's definition. */
    public LevelBody definition() {
        return definition;
    }

    /** Its handle; no longer alive after it was deleted, blew up or fell out of the world. */
    public RigidBody body() {
        return body;
    }

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
    public boolean isClickable() {
        return Target.super.isClickable() && !isFrozen && fuse.isEmpty();
    }

    @Override
    public boolean isOn() {
        return isOn;
    }

    @Override
    public double x() {
        return body.x();
    }

    @Override
    public double y() {
        return body.y();
    }

    /** Its present substance: stone after it was frozen. */
    public Substance substance() {
        return isFrozen ? Substance.STONE : definition.substance();
    }

    /**
     * Speed of its surface while it is on, m/s, positive counter-clockwise; 0 if it is not a belt.
     */
    public double beltSpeed() {
        return definition.material().surfaceSpeed();
    }

    /** The fuse of a bomb that was lit. */
    public Optional<Fuse> fuse() {
        return fuse;
    }

    /** The melting of a fire door that a ball has touched. */
    public Optional<Melt> melt() {
        return melt;
    }

    void flip() {
        isOn = !isOn;
        if (beltSpeed() != 0) {
            body.material(body.material().surfaceSpeed(isOn ? beltSpeed() : 0));
        }
    }

    void freeze() {
        isFrozen = true;
        melt = Optional.empty();
        body.type(BodyType.STATIC);
        body.material(Substance.STONE.material());
    }

    void light(Fuse lit) {
        fuse = Optional.of(lit);
    }

    void melt(Melt begun) {
        melt = Optional.of(begun);
    }
}
