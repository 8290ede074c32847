package rigibo.frontend.puzzle.generate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.check.Figures;
import rigibo.frontend.puzzle.check.LevelProof;
import rigibo.frontend.puzzle.level.Clickable;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Origin;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.rules.Bookmarks;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.LongStream;

/** Levels of a few seeds, made once for all tests here. */
@Execution(ExecutionMode.CONCURRENT)
class GeneratorTest {

    private static final long FIRST = 21;
    private static final int COUNT = 3;

    /** Hash of the level of the first seed. */
    private static final long HASH = -9_022_159_366_812_882_962L;

    private static List<Generated> levels;

    @BeforeAll
    static void make() {
        Generator generator = new Generator();
        levels =
                LongStream.range(FIRST, FIRST + COUNT)
                        .mapToObj(seed -> generator.level(seed).orElseThrow())
                        .toList();
    }

    @Test
    void sameSeedGivesTheSameFile() {
        Generated again = new Generator().level(FIRST).orElseThrow();
        assertThat(again.text()).isEqualTo(levels.get(0).text());
        assertThat(again.figures()).isEqualTo(levels.get(0).figures());
        assertThat(again.effort()).isEqualTo(levels.get(0).effort());
    }

    /**
     * A change of the levels made must raise {@link Generator#VERSION}, or replays of former levels
     * would be played in others; the hash here changes with it. A new revision of the simulation
     * may also change which plans are puzzles, and replays state their revision.
     */
    @Test
    void seedKeepsItsLevelAsLongAsTheVersionStays() {
        Level level = levels.get(0).level();
        assertThat(level.origin()).contains(new Origin(FIRST, Generator.VERSION));
        assertThat(Generator.VERSION).isEqualTo(1);
        assertThat(level.hash()).isEqualTo(HASH);
    }

    @Test
    void otherSeedsGiveOtherLevels() {
        assertThat(levels.stream().map(each -> each.level().hash())).doesNotHaveDuplicates();
    }

    /** Reads the file again and plays it as the command does, without a sieve. */
    @Test
    void everyLevelPassesTheCheckOfLevels() {
        for (Generated each : levels) {
            List<Problem> problems =
                    LevelProof.problems(each.level().id(), each.text(), games -> {});
            assertThat(problems).as(each.text()).isEmpty();
        }
    }

    /** The search of orders rests on it: what games have in common is played once. */
    @Test
    void gamesGoOnFromTheirMiddleToTheSameBits() {
        for (Generated each : levels) {
            Level level = each.level();
            Replay solution = Replay.of(level, level.solutions().get(0), Accuracy.GAME);
            Playback whole = new Playback(level, solution);
            List<Bookmarks.Bookmark> kept = new ArrayList<>();
            while (whole.game().outcome() == Outcome.RUNNING) {
                if (whole.game().steps() % 40 == 0) {
                    kept.add(new Bookmarks(level).at(whole.game()));
                }
                whole.step();
            }
            for (Bookmarks.Bookmark begin : kept) {
                Playback part = new Playback(begin.game(), solution);
                part.stepTo(whole.game().steps());
                assertThat(part.game().outcome()).isEqualTo(Outcome.WON);
                assertThat(part.game().checkpoints()).isEqualTo(whole.game().checkpoints());
            }
        }
    }

    @Test
    void everyLevelIsAPuzzleByItsFigures() {
        for (Generated each : levels) {
            Figures figures = each.figures();
            assertThat(figures.par()).as(each.text()).isBetween(2, 5);
            assertThat(figures.share()).as(each.text()).isBetween(0.0, 0.3);
            assertThat(figures.falseLeads().size() + figures.traps().size())
                    .as(each.text())
                    .isPositive();
        }
    }

    @Test
    void figuresAreThoseOfTheLevel() {
        for (Generated each : levels) {
            Level level = each.level();
            assertThat(each.figures().par()).isEqualTo(level.limits().par());
            assertThat(level.solutions().get(0).clicks()).hasSize(level.limits().par());
            assertThat(level.clickables())
                    .hasSize(each.figures().clickables())
                    .allMatch(one -> one.verb() == Verb.DELETE);
            assertThat(level.clickables().stream().map(Clickable::id))
                    .containsAll(each.figures().falseLeads())
                    .containsAll(each.figures().traps());
        }
    }

    /** Each game is reported; the last report is the effort of the level. */
    @Test
    void everyGameIsTold() {
        List<Generated.Effort> told = new ArrayList<>();
        Generated made = new Generator(told::add).first(List.of(FIRST)).orElseThrow();
        assertThat(made.text()).isEqualTo(levels.get(0).text());
        assertThat(told).hasSize((int) made.effort().games()).endsWith(made.effort());
        assertThat(told.stream().map(Generated.Effort::steps)).isSorted();
    }

    @Test
    void interruptedThreadStopsTheSearch() {
        Thread.currentThread().interrupt();
        try {
            assertThatThrownBy(() -> new Generator().level(FIRST))
                    .isInstanceOf(CancellationException.class);
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {-1, Generator.LAST_SEED + 1, Long.MIN_VALUE})
    void seedOutOfRangeIsRefused(long seed) {
        assertThatThrownBy(() -> new Generator().level(seed))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the seed must be 0 to 999999999999, was " + seed);
    }
}
