package rigibo.lab.ablation.probe;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Thrust;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * The bodies of a scene that suits an effect, some of which use it.
 *
 * @param scene the bodies and their drive
 * @param base the effects declared beside the effect
 * @param effect with its parameters
 * @param neutral the effect with parameters by which it does nothing, for an effect that acts on
 *     all bodies while none is to use it; otherwise the effect itself
 * @param words how a body uses it
 * @param user makes, from a body's definition, the bodies of a user: itself, perhaps changed, and
 *     those that it needs
 * @param idler likewise for a body that does not use it
 * @param push drives a user before each step
 */
public record Use(
        Workload scene,
        Effects base,
        Effect effect,
        Effect neutral,
        String words,
        Function<BodyDefinition, List<BodyDefinition>> user,
        UnaryOperator<BodyDefinition> idler,
        Consumer<RigidBody> push) {

    /** The push of bodies that need none. */
    private static final Consumer<RigidBody> NO_PUSH = body -> {};

    /** A use in which users and others are the bodies of the scene, unchanged. */
    static Use of(Workload scene, Effects base, Effect effect, String words) {
        UnaryOperator<BodyDefinition> same = UnaryOperator.identity();
        return new Use(scene, base, effect, effect, words, List::of, same, NO_PUSH);
    }

    Use neutral(Effect other) {
        return new Use(scene, base, effect, other, words, user, idler, push);
    }

    Use user(UnaryOperator<BodyDefinition> change) {
        return users(body -> List.of(change.apply(body)));
    }

    /** A copy whose users come with other bodies. */
    Use users(Function<BodyDefinition, List<BodyDefinition>> bodies) {
        return new Use(scene, base, effect, neutral, words, bodies, idler, push);
    }

    Use idler(UnaryOperator<BodyDefinition> change) {
        return new Use(scene, base, effect, neutral, words, user, change, push);
    }

    Use push(Consumer<RigidBody> pushed) {
        return new Use(scene, base, effect, neutral, words, user, idler, pushed);
    }

    /** The effect's simple name. */
    public String name() {
        return effect.getClass().getSimpleName();
    }

    /** The shares of users that are possible: all or none for an effect that acts on all bodies. */
    public List<Share> shares() {
        return effect == neutral ? List.of(Share.values()) : List.of(Share.NONE, Share.ALL);
    }

    /** The number of bodies that use it. */
    public int users(Share share) {
        return share.of((int) scene.bodies().stream().filter(Use::mayUse).count());
    }

    /** Whether a body may use an effect; fixed bodies do not. */
    private static boolean mayUse(BodyDefinition body) {
        return body.type() == BodyType.DYNAMIC;
    }

    /** The scene with the effect declared, which a share of the bodies uses. */
    public Workload declared(Share share) {
        return used(share, base.with(share == Share.NONE ? neutral : effect), push);
    }

    /** Its bodies with the effect left undeclared. */
    public Workload undeclared(Share share) {
        return used(share, base, NO_PUSH);
    }

    /** The scene whose first bodies use the effect. */
    private Workload used(Share share, Effects effects, Consumer<RigidBody> pushed) {
        int users = users(share);
        Consumer<Pool> drive = effects.declares(Thrust.class) ? scene.drive() : Workload.UNDRIVEN;
        if (pushed != NO_PUSH) {
            drive = drive.andThen(pool -> push(pool, users, pushed));
        }
        if (effects.declares(Joints.class) && users > 0) {
            drive = drive.andThen(new Joiner(users));
        }
        return scene.with(effects, () -> bodies(users, effects.declares(Sensors.class)), drive);
    }

    /** Pushes the users, which are the first bodies of a scene. */
    private static void push(Pool pool, int users, Consumer<RigidBody> pushed) {
        for (int i = 0; i < users; i++) {
            pushed.accept(pool.bodies().get(i));
        }
    }

    /** The bodies of the scene; sensors are left out if undeclared, since they are refused. */
    private List<BodyDefinition> bodies(int users, boolean senses) {
        List<BodyDefinition> all = new ArrayList<>();
        int met = 0;
        for (BodyDefinition body : scene.bodies()) {
            if (!mayUse(body)) {
                all.add(body);
            } else if (met++ < users) {
                all.addAll(user.apply(body));
            } else {
                all.add(idler.apply(body));
            }
        }
        all.removeIf(body -> body.isSensor() && !senses);
        return all;
    }
}
