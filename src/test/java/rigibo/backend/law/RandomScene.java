package rigibo.backend.law;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * A scene drawn from a seed.
 *
 * @param seed what it was drawn from
 * @param effects what is simulated
 * @param accuracy how exactly
 * @param steps of {@link #DT} that a law looks at
 * @param bodies in the order they are added
 * @param links in the order they are joined; those of bodies that are left out are left out too
 */
record RandomScene(
        long seed,
        Effects effects,
        Accuracy accuracy,
        int steps,
        List<BodyDefinition> bodies,
        List<Link> links) {

    /** A game's step, s. */
    static final double DT = 1.0 / 60;

    /** Bodies that nothing joins. */
    RandomScene(
            long seed, Effects effects, Accuracy accuracy, int steps, List<BodyDefinition> bodies) {
        this(seed, effects, accuracy, steps, bodies, List.of());
    }

    RandomScene bodies(List<BodyDefinition> others) {
        return new RandomScene(seed, effects, accuracy, steps, List.copyOf(others), links);
    }

    RandomScene links(List<Link> others) {
        return new RandomScene(seed, effects, accuracy, steps, bodies, List.copyOf(others));
    }

    RandomScene effects(Effects others) {
        return new RandomScene(seed, others, accuracy, steps, bodies, links);
    }

    RandomScene steps(int count) {
        return new RandomScene(seed, effects, accuracy, count, bodies, links);
    }

    /** Whether a body is left that forces and contacts move. */
    boolean canMove() {
        return bodies.stream().anyMatch(body -> body.type() == BodyType.DYNAMIC);
    }

    Pool pool() {
        Pool pool = new Pool(effects, accuracy);
        Map<BodyDefinition, RigidBody> added = new IdentityHashMap<>();
        bodies.forEach(body -> added.put(body, pool.add(body)));
        links.stream()
                .filter(link -> added.keySet().containsAll(link.bodies()))
                .forEach(link -> link.join(pool, added::get));
        return pool;
    }

    /** The pool after all steps. */
    Pool finished() {
        Pool pool = pool();
        for (int i = 0; i < steps; i++) {
            pool.step(DT);
        }
        return pool;
    }

    /** Enough to build it again by hand. */
    String words() {
        String lines = bodies.stream().map(SceneWords::of).collect(Collectors.joining("\n"));
        String joined =
                links.stream()
                        .filter(link -> bodies.containsAll(link.bodies()))
                        .map(link -> "\n" + link.words(bodies))
                        .collect(Collectors.joining());
        return steps + " steps of 1/60 s, " + accuracy + ",\n" + effects + "\n" + lines + joined;
    }
}
