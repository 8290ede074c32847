package rigibo.frontend.scene.ghost;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.function.Consumer;

/**
 * A copy of a scene that goes on at another accuracy from where the scene is. Whatever is done to
 * the scene's bodies from then on is done to their twins as well, so that the two differ by their
 * accuracy alone. The scene itself is only looked at.
 */
public final class Ghost {

    private final Pool original;
    private final Pool copy;
    private final Preset preset;
    private final Map<RigidBody, RigidBody> twins = new IdentityHashMap<>();
    private final Divergence divergence = new Divergence();

    /**
     * The ghost that tells most of a scene: one that is more exact, so that its distance is the
     * scene's own error; of EXACT, which has none to be told, the game's.
     */
    public static Ghost of(Pool original) {
        boolean isExact = original.accuracy().equals(Preset.EXACT.accuracy());
        Preset next = Preset.of(original.accuracy()).map(Preset::next).orElse(Preset.EXACT);
        return new Ghost(original, isExact ? Preset.GAME : next);
    }

    /** A ghost at an accuracy of choice. */
    public Ghost(Pool original, Preset preset) {
        this.original = original;
        this.preset = preset;
        copy = Pool.restore(original.snapshot(), original.effects());
        copy.accuracy(preset.accuracy());
        Iterator<RigidBody> copies = copy.bodies().iterator();
        original.bodies().forEach(body -> twins.put(body, copies.next()));
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
        copy.remove(twins.remove(body));
    }

    /** Does to a body's twin what was done to the body. */
    public void act(RigidBody body, Consumer<RigidBody> verb) {
        verb.accept(twins.get(body));
    }

    /** Follows a step of the scene of {@code dt} seconds. */
    public void step(double dt) {
        if (!copy.effects().equals(original.effects())) {
            copy.effects(original.effects());
        }
        copy.step(dt);
        divergence.step(original, copy);
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
