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
 * How bodies of the scene that suits an effect use it, or do not.
 *
 * @param scene the bodies and what drives them
 * @param base what is declared beside the effect
 * @param effect with its parameters
 * @param neutral with parameters by which it does nothing, where nobody is to use one that acts on
 *     all bodies; else the effect itself
 * @param words how a body uses it
 * @param user what a user puts into the scene, of its definition: itself, perhaps changed, and what
 *     it needs beside it
 * @param idler what is put there for a body that does not use it
 * @param push what drives a user before each step
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

    /** What moves by itself. */
    private static final Consumer<RigidBody> NO_PUSH = body -> {};

    /** Users are as they are, and so are the others. */
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

    /** For users that need something beside them. */
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

    /** How many may use it: all or none of what acts on all bodies or does nothing. */
    public List<Share> shares() {
        return effect == neutral ? List.of(Share.values()) : List.of(Share.NONE, Share.ALL);
    }

    /** How many bodies use it. */
    public int users(Share share) {
        return share.of((int) scene.bodies().stream().filter(Use::mayUse).count());
    }

    /** What never moves uses nothing. */
    private static boolean mayUse(BodyDefinition body) {
        return body.type() == BodyType.DYNAMIC;
    }

    /** The scene in which so many use the effect, which is declared. */
    public Workload declared(Share share) {
        return used(share, base.with(share == Share.NONE ? neutral : effect), push);
    }

    /** The same bodies where it is not. */
    public Workload undeclared(Share share) {
        return used(share, base, NO_PUSH);
    }

    /** The first ones use it. */
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

    /** Whoever is pushed is among the first bodies: those scenes add nothing before them. */
    private static void push(Pool pool, int users, Consumer<RigidBody> pushed) {
        for (int i = 0; i < users; i++) {
            pushed.accept(pool.bodies().get(i));
        }
    }

    /** Where sensors are not declared there are none, for they would be refused. */
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
