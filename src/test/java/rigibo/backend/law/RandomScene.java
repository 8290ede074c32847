package rigibo.backend.law;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.List;
import java.util.stream.Collectors;

/**
 * A scene drawn from a seed.
 *
 * @param seed what it was drawn from
 * @param effects what is simulated
 * @param accuracy how exactly
 * @param steps of {@link #DT} that a law looks at
 * @param bodies in the order they are added
 */
record RandomScene(
        long seed, Effects effects, Accuracy accuracy, int steps, List<BodyDefinition> bodies) {

    /** A game's step, s. */
    static final double DT = 1.0 / 60;

    RandomScene bodies(List<BodyDefinition> others) {
        return new RandomScene(seed, effects, accuracy, steps, List.copyOf(others));
    }

    RandomScene effects(Effects others) {
        return new RandomScene(seed, others, accuracy, steps, bodies);
    }

    RandomScene steps(int count) {
        return new RandomScene(seed, effects, accuracy, count, bodies);
    }

    /** Whether a body is left that forces and contacts move. */
    boolean canMove() {
        return bodies.stream().anyMatch(body -> body.type() == BodyType.DYNAMIC);
    }

    Pool pool() {
        Pool pool = new Pool(effects, accuracy);
        bodies.forEach(pool::add);
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
        return steps + " steps of 1/60 s, " + accuracy + ",\n" + effects + "\n" + lines;
    }
}
