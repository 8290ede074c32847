package rigibo.frontend.scene.ghost;

import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.function.Consumer;

/**
 * A copy of a scene that continues at another accuracy from the scene's present state. Every later
 * change of the scene's bodies is also made to their twins, so that the two differ by accuracy
 * alone. The scene itself is only read.
 */
public final class Ghost {

    private final Pool original;
    private final Pool copy;
    private final Preset preset;
    private Twins twins;
    private final Divergence divergence = new Divergence();

    /**
     * The ghost that tells most of a scene: one that is more exact, so that its distance is the
     * scene's own error; of EXACT, which has none to be told, the game's.
     */
    public static Ghost of(Pool original) {
        return new Ghost(original, telling(original));
    }

    /**
     * A ghost of a scene that does more by itself than its bodies tell, and has made no step yet:
     * with a copy in which its owner does as much.
     */
    public static Ghost of(Pool original, Pool copy) {
        return new Ghost(original, copy, telling(original));
    }

    private static Preset telling(Pool original) {
        boolean isExact = original.accuracy().equals(Preset.EXACT.accuracy());
        Preset next = Preset.of(original.accuracy()).map(Preset::next).orElse(Preset.EXACT);
        return isExact ? Preset.GAME : next;
    }

    /** A ghost at an accuracy of choice. */
    public Ghost(Pool original, Preset preset) {
        this(original, Pool.restore(original.snapshot(), original.effects()), preset);
    }

    private Ghost(Pool original, Pool copy, Preset preset) {
        this.original = original;
        this.copy = copy;
        this.preset = preset;
        copy.accuracy(preset.accuracy());
        twins = new Twins(original, copy);
    }

    /** Its accuracy. */
    public Preset preset() {
        return preset;
    }

    /** How far it has come from the scene. */
    public Divergence divergence() {
        return divergence;
    }

    /** A body was added to the scene. */
    public void added(RigidBody body, BodyDefinition definition) {
        twins.put(body, copy.add(definition));
    }

    /** A body was taken out of the scene. */
    public void removed(RigidBody body) {
        copy.remove(twins.drop(body));
    }

    /** The owner of both has added or removed bodies and joints: they are twins by their places. */
    public void paired() {
        boolean isAlike =
                original.bodies().size() == copy.bodies().size()
                        && original.joints().size() == copy.joints().size();
        if (isAlike) {
            twins = new Twins(original, copy);
        }
    }

    /** Whether a body of the scene has a twin. */
    public boolean follows(RigidBody body) {
        RigidBody twin = twins.of(body);
        return twin != null && twin.isAlive();
    }

    /** Whether a joint of the scene has a twin. */
    public boolean follows(Joint joint) {
        return twins.of(joint) != null;
    }

    /** A joint was made in the scene. */
    public void joined(Joint joint, JointDefinition definition) {
        followEffects();
        twins.put(joint, copy.join(twins.of(definition)));
    }

    /** A joint was ended in the scene; in the copy it may have broken before. */
    public void parted(Joint joint) {
        Joint twin = twins.drop(joint);
        if (twin.isAlive()) {
            copy.remove(twin);
        }
    }

    /** Applies the changes of a joint to its twin, unless the twin has broken. */
    public void act(Joint joint, Consumer<Joint> verb) {
        Joint twin = twins.of(joint);
        if (twin.isAlive()) {
            verb.accept(twin);
        }
    }

    /** Where a body of the scene is in the copy. */
    public RigidBody twin(RigidBody body) {
        return twins.of(body);
    }

    /** Applies the changes of a body to its twin. */
    public void act(RigidBody body, Consumer<RigidBody> verb) {
        verb.accept(twins.of(body));
    }

    /** Follows a step of the scene of {@code dt} seconds. */
    public void step(double dt) {
        followEffects();
        copy.step(dt);
        divergence.step(original, copy);
    }

    private void followEffects() {
        if (!copy.effects().equals(original.effects())) {
            copy.effects(original.effects());
        }
    }

    /** Draws the outlines of what can move. */
    public void draw(Canvas canvas) {
        for (RigidBody body : copy.bodies()) {
            if (body.type() != BodyType.STATIC) {
                double angle = body.angle();
                canvas.body(body.shape(), body.x(), body.y(), angle, Skin.BALL, Canvas.Mood.GHOST);
            }
        }
    }
}
