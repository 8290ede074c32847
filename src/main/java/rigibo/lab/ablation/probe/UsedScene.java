package rigibo.lab.ablation.probe;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Thrust;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** A scene in which a share of the dynamic bodies use an effect: the first ones. */
final class UsedScene implements Workload {

    /** Length of the rod between a user of joints and its partner, m. */
    static final double ROD = 0.3;

    private final Use use;
    private final Share share;
    private final Effects effects;
    private final Consumer<RigidBody> push;
    private final int users;
    private final boolean isDriven;
    private final int pushed;
    private final int joined;

    /** The pool whose users are joined. */
    private Pool joinedIn;

    UsedScene(Use use, Share share, Effects effects, Consumer<RigidBody> push) {
        this.use = use;
        this.share = share;
        this.effects = effects;
        this.push = push;
        users = use.users(share);
        isDriven = effects.declares(Thrust.class);
        pushed = push == Use.NO_PUSH ? 0 : users;
        joined = effects.declares(Joints.class) ? users : 0;
    }

    @Override
    public String name() {
        return use.scene().name();
    }

    @Override
    public String words() {
        return use.scene().words() + ", " + share;
    }

    @Override
    public Effects effects() {
        return effects;
    }

    @Override
    public List<BodyDefinition> bodies() {
        List<BodyDefinition> all = new ArrayList<>();
        int met = 0;
        for (BodyDefinition body : use.scene().bodies()) {
            if (!Use.mayUse(body)) {
                all.add(body);
            } else if (met++ < users) {
                all.addAll(use.user().apply(body));
            } else {
                all.addAll(use.idler().apply(body));
            }
        }
        // Undeclared there are none, for they would be refused.
        boolean senses = effects.declares(Sensors.class);
        all.removeIf(body -> body.isSensor() && !senses);
        return all;
    }

    @Override
    public int stepsToSettle() {
        return use.scene().stepsToSettle();
    }

    @Override
    public int period() {
        return use.scene().period();
    }

    /** Whoever is pushed is among the first bodies: those scenes add nothing before them. */
    @Override
    public void drive(Pool pool) {
        if (isDriven) {
            use.scene().drive(pool);
        }
        for (int i = 0; i < pushed; i++) {
            push.accept(pool.bodies().get(i));
        }
        if (joined > 0 && joinedIn != pool) {
            join(pool);
        }
    }

    /** Joins every user with its partner, who comes after it. */
    private void join(Pool pool) {
        joinedIn = pool;
        List<RigidBody> bodies = pool.bodies();
        for (int i = 0; i < joined; i++) {
            RigidBody user = bodies.get(2 * i);
            RigidBody partner = bodies.get(2 * i + 1);
            pool.join(
                    DistanceJoint.rod(user, user.x(), user.y(), partner, partner.x(), partner.y()));
        }
    }
}
