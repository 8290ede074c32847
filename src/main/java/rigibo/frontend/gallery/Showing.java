package rigibo.frontend.gallery;

import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Bench;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.ghost.Ghost;

import java.util.Optional;
import java.util.function.Consumer;

/**
 * A running exhibit and its pool; with a ghost, also a second instance of the exhibit in a pool of
 * another accuracy. An exhibit acts by itself upon bodies that it has kept, so that a copy of its
 * pool alone would stand still where the exhibit drives something.
 */
final class Showing implements Bench {

    private final Exhibit exhibit;
    private final Pool pool;
    private Optional<Haunting> haunting = Optional.empty();

    /** How many bodies and joints there were when their twins were last sought. */
    private int paired;

    private record Haunting(Exhibit exhibit, Pool copy, Ghost ghost) {}

    Showing(Exhibit exhibit) {
        this.exhibit = exhibit;
        pool = exhibit.open();
        pool.clock(System::nanoTime);
    }

    /** Begins to run another instance of the exhibit as a ghost; before the first step. */
    void haunt(Exhibit other) {
        Pool copy = other.open();
        haunting = Optional.of(new Haunting(other, copy, Ghost.of(pool, copy)));
        paired = count();
    }

    private int count() {
        return pool.bodies().size() + pool.joints().size();
    }

    Exhibit exhibit() {
        return exhibit;
    }

    Optional<Ghost> ghost() {
        return haunting.map(Haunting::ghost);
    }

    @Override
    public Pool pool() {
        return pool;
    }

    void step() {
        exhibit.beforeStep(pool);
        haunting.ifPresent(one -> one.exhibit.beforeStep(one.copy));
        pair();
        pool.step(Scene.STEP);
        ghost().ifPresent(ghost -> ghost.step(Scene.STEP));
    }

    /** The right button was pressed at a point of the world, m. */
    void act(double x, double y) {
        exhibit.act(pool, x, y);
        haunting.ifPresent(one -> one.exhibit.act(one.copy, x, y));
        pair();
    }

    private void pair() {
        if (haunting.isPresent() && count() != paired) {
            haunting.get().ghost.paired();
            paired = count();
        }
    }

    @Override
    public Joint join(JointDefinition definition) {
        Joint joint = pool.join(definition);
        ghost().filter(any -> any.follows(definition.a()) && any.follows(definition.b()))
                .ifPresent(any -> any.joined(joint, definition));
        paired = count();
        return joint;
    }

    @Override
    public void part(Joint joint) {
        pool.remove(joint);
        ghost().filter(any -> any.follows(joint)).ifPresent(any -> any.parted(joint));
        paired = count();
    }

    @Override
    public void act(RigidBody body, Consumer<RigidBody> verb) {
        verb.accept(body);
        ghost().filter(any -> any.follows(body)).ifPresent(any -> any.act(body, verb));
    }

    @Override
    public void act(Joint joint, Consumer<Joint> verb) {
        verb.accept(joint);
        ghost().filter(any -> any.follows(joint)).ifPresent(any -> any.act(joint, verb));
    }

    /** Bodies that touch nothing are drawn as outlines, sleeping ones dimmed. */
    static Canvas.Mood mood(RigidBody body) {
        if (!body.isEnabled() || body.isSensor()) {
            return Canvas.Mood.GHOST;
        }
        boolean isAsleep = body.type() == BodyType.DYNAMIC && !body.isAwake();
        return isAsleep ? Canvas.Mood.ASLEEP : Canvas.Mood.PLAIN;
    }
}
