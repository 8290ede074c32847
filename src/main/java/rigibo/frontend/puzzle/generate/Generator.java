package rigibo.frontend.puzzle.generate;

import rigibo.frontend.puzzle.check.Figures;
import rigibo.frontend.puzzle.check.Sieve;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.Origin;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Makes the level of a seed: tries plan after plan until one is a puzzle. */
public final class Generator {

    /**
     * Version of the generator. It rises whenever a seed gets another level than before, so that
     * replays of the former level are recognised.
     */
    public static final int VERSION = 1;

    /** Plans tried with a seed; if all fail, the seed has no level, on any machine. */
    private static final int ATTEMPTS = 100;

    /**
     * Boxes that a plan must have, in all and besides those to delete. With fewer, too large a
     * share of the choices of par boxes is right: 1 of 3 with 2 of 3 boxes, but 1 of 4 with 3 of 4.
     */
    private static final int LEAST_BOXES = 4;

    private static final int LEAST_DECOYS = 1;

    /** The largest seed; all seeds from 0 to this one have levels of their own. */
    public static final long LAST_SEED = 999_999_999_999L;

    private final LevelLoader loader = new LevelLoader();
    private final Consumer<Generated.Effort> told;

    /** A generator that does not report its work. */
    public Generator() {
        this(effort -> {});
    }

    /**
     * A generator.
     *
     * @param told receives the work so far on the present seed, after each game, on the calling
     *     thread
     */
    public Generator(Consumer<Generated.Effort> told) {
        this.told = told;
    }

    /** Makes the level of the first of some seeds that has one; empty if none has. */
    public Optional<Generated> first(List<Long> seeds) {
        return seeds.stream().map(this::level).flatMap(Optional::stream).findFirst();
    }

    /**
     * Makes a level, which takes seconds. Uses the calling thread alone.
     *
     * @param seed decides the level, 0 to {@link #LAST_SEED}
     * @return the level; empty if none of the plans of this seed is a puzzle
     * @throws IllegalArgumentException when the seed is not in this range
     * @throws java.util.concurrent.CancellationException when the thread was interrupted
     */
    public Optional<Generated> level(long seed) {
        if (seed < 0 || seed > LAST_SEED) {
            throw new IllegalArgumentException(
                    "the seed must be 0 to " + LAST_SEED + ", was " + seed);
        }
        Search search = new Search();
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            search.plans++;
            Plan plan = Architect.plan(new Chance(seed, attempt));
            Optional<Draft> draft = hasChoice(plan) ? draft(seed, plan) : Optional.empty();
            Optional<Figures> figures = draft.flatMap(made -> search.sieve.figures(made.level));
            if (figures.isPresent()) {
                Level level = draft.get().level.madeFrom(new Origin(seed, VERSION));
                return Optional.of(
                        new Generated(draft.get().text, level, figures.get(), search.effort()));
            }
        }
        return Optional.empty();
    }

    /** The work done for a seed so far. */
    private final class Search {

        private final Sieve sieve = new Sieve(games -> told.accept(effort()));
        private int plans;

        Generated.Effort effort() {
            return new Generated.Effort(plans, sieve.games(), sieve.steps());
        }
    }

    private static boolean hasChoice(Plan plan) {
        int decoys = plan.boxes() - plan.clicks().size();
        return decoys >= LEAST_DECOYS && plan.boxes() >= LEAST_BOXES;
    }

    /** A plan as a file, and the level in it. */
    private record Draft(String text, Level level) {}

    /** A plan as a level with its solution; empty if its parts collide or it cannot be won. */
    private Optional<Draft> draft(long seed, Plan plan) {
        Sheet sheet = new Sheet(seed, plan);
        return read(sheet.text())
                .flatMap(level -> Rehearsal.solution(level, plan.clicks()))
                .map(sheet::text)
                .flatMap(text -> read(text).map(level -> new Draft(text, level)));
    }

    private Optional<Level> read(String text) {
        return loader.parse("a plan", text).level();
    }
}
