package rigibo.lab.ablation.probe;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * How bodies of the scene that suits an effect use it, or do not.
 *
 * @param scene the bodies and what drives them
 * @param base what is declared beside the effect
 * @param effect with its parameters, by how many use it
 * @param words how a body uses it
 * @param user what a user puts into the scene, of its definition: itself, perhaps changed, and what
 *     it needs beside it
 * @param idler the same for a body that does not use it
 * @param push what drives a user before each step
 * @param shares how many may use it
 */
public record Use(
        Workload scene,
        Effects base,
        Function<Share, Effect> effect,
        String words,
        Function<BodyDefinition, List<BodyDefinition>> user,
        Function<BodyDefinition, List<BodyDefinition>> idler,
        Consumer<RigidBody> push,
        List<Share> shares) {

    /** What moves by itself. */
    static final Consumer<RigidBody> NO_PUSH = body -> {};

    /** The effect's simple name. */
    public String name() {
        return effect.apply(Share.ALL).getClass().getSimpleName();
    }

    /** How many bodies use it. */
    public int users(Share share) {
        return share.of((int) scene.bodies().stream().filter(Use::mayUse).count());
    }

    /** What never moves uses nothing. */
    static boolean mayUse(BodyDefinition body) {
        return body.type() == BodyType.DYNAMIC;
    }

    /** The scene in which so many use the effect, which is declared. */
    public Workload declared(Share share) {
        return new UsedScene(this, share, base.with(effect.apply(share)), push);
    }

    /** The same bodies where it is not. */
    public Workload undeclared(Share share) {
        return new UsedScene(this, share, base, NO_PUSH);
    }
}
