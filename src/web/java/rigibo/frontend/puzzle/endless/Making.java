package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.generate.Generated;
import rigibo.frontend.puzzle.generate.Generator;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.Origin;
import rigibo.web.aside.Aside;

import java.util.List;
import java.util.Optional;

/** Makes a level on a thread beside the page, which goes on meanwhile. */
public final class Making {

    /** Name of the errand; its words are the seeds. */
    public static final String ERRAND = "making";

    private static final String EFFORT = "effort";
    private static final String MADE = "made";
    private static final String NONE = "none";

    private final Aside aside;
    private Optional<Made> made = Optional.empty();
    private Optional<Generated.Effort> effort = Optional.empty();
    private boolean isHopeless;

    /**
     * A level that was made.
     *
     * @param seed whose level it is
     * @param level decided by the seed
     */
    public record Made(long seed, Level level) {}

    private Making(List<Long> seeds) {
        aside = Aside.begin(ERRAND, seeds.stream().map(String::valueOf).toList(), this::told);
    }

    /** Begins to make the level of the first of some seeds that has one. */
    public static Making begin(List<Long> seeds) {
        return new Making(seeds);
    }

    /** Makes the level and reports it to the page; called by the thread beside it. */
    public static void make(List<String> seeds) {
        Optional<Generated> found =
                new Generator(Making::tell).first(seeds.stream().map(Long::valueOf).toList());
        Aside.tell(found.map(Making::words).orElse(List.of(NONE)));
    }

    private static void tell(Generated.Effort now) {
        Aside.tell(
                List.of(
                        EFFORT,
                        String.valueOf(now.plans()),
                        String.valueOf(now.games()),
                        String.valueOf(now.steps())));
    }

    private static List<String> words(Generated found) {
        long seed = found.level().origin().orElseThrow().seed();
        return List.of(MADE, String.valueOf(seed), found.text());
    }

    private void told(List<String> words) {
        switch (words.isEmpty() ? NONE : words.get(0)) {
            case EFFORT ->
                    effort =
                            Optional.of(
                                    new Generated.Effort(
                                            Integer.parseInt(words.get(1)),
                                            Long.parseLong(words.get(2)),
                                            Long.parseLong(words.get(3))));
            case MADE -> {
                made = Optional.of(read(Long.parseLong(words.get(1)), words.get(2)));
                stop();
            }
            default -> {
                isHopeless = true;
                stop();
            }
        }
    }

    private static Made read(long seed, String text) {
        Level level = new LevelLoader().parse("a plan", text).level().orElseThrow();
        return new Made(seed, level.madeFrom(new Origin(seed, Generator.VERSION)));
    }

    /** The level; empty while it is being made. */
    public Optional<Made> made() {
        return made;
    }

    /** The work so far on a seed; empty before the first game. */
    public Optional<Generated.Effort> effort() {
        return effort;
    }

    /** Whether none of the seeds has a level. */
    public boolean isHopeless() {
        return isHopeless;
    }

    /** Stops at once. */
    public void stop() {
        aside.stop();
    }
}
