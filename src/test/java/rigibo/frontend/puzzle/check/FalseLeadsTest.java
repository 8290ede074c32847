package rigibo.frontend.puzzle.check;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;

import java.util.List;
import java.util.Set;

class FalseLeadsTest {

    /**
     * The ball lies on a slope that leads past the platform and out of the world; only a box holds
     * it.
     */
    private static final String PAST_THE_PLATFORM =
            LevelTexts.with("\"x\": 4.5, \"y\": 2.7", "\"x\": 0.85, \"y\": 7.85")
                    .replace(
                            "\"x\": 4.5, \"y\": 1.2, \"w\": 3.6",
                            "\"x\": 4.5, \"y\": 1.2, \"w\": 2")
                    .replace(
                            "\"w\": 2, \"h\": 1}, \"x\": 4.5, \"y\": 1.85",
                            "\"w\": 0.6, \"h\": 0.8}, \"x\": 1.57, \"y\": 7.77")
                    .replace(
                            "{\"type\": \"box\", \"w\": 0.5, \"h\": 4}, \"x\": 8, \"y\": 2",
                            "{\"type\": \"polygon\", \"points\": [[0, 7], [8.9, 5], [8.9, 5.65],"
                                    + " [0, 7.65]]}, \"x\": 0, \"y\": 0");

    /** The ball drops from its box onto stone, nearer to the platform, and stays there. */
    private static final String ONTO_A_SHELF =
            LevelTexts.with("\"x\": 4.5, \"y\": 2.7", "\"x\": 1, \"y\": 4.35")
                    .replace("\"w\": 2, \"h\": 1}, \"x\": 4.5", "\"w\": 1, \"h\": 1}, \"x\": 1")
                    .replace("\"y\": 1.85", "\"y\": 3.5")
                    .replace(
                            "\"w\": 0.5, \"h\": 4}, \"x\": 8, \"y\": 2",
                            "\"w\": 1, \"h\": 3}, \"x\": 1, \"y\": 1.5");

    private static List<String> leads(Level level, String... winning) {
        return leads(level, FalseLeads.Losses.OF_THE_BALL, Set.of(winning));
    }

    private static List<String> leads(Level level, FalseLeads.Losses losses, Set<String> winning) {
        return new FalseLeads(level, new Games(Games.Cores.ONE, games -> {}), losses)
                .first(winning);
    }

    @Test
    void clickThatWinsIsNoFalseLead() {
        assertThat(leads(LevelTexts.sound(), "box")).isEmpty();
    }

    @Test
    void clickThatLeadsPastThePlatformAndOutOfTheWorldIsOne() {
        assertThat(leads(LevelTexts.level(PAST_THE_PLATFORM))).containsExactly("box");
    }

    @Test
    void clickThatOnlyLosesTheBallIsNone() {
        String elsewhere =
                LevelTexts.with("\"x\": 4.5, \"y\": 2.7", "\"x\": 0.5, \"y\": 1.85")
                        .replace("\"x\": 4.5, \"y\": 1.85", "\"x\": 0.5, \"y\": 1")
                        .replace("\"w\": 2, \"h\": 1", "\"w\": 0.8, \"h\": 1")
                        .replace(
                                "\"w\": 0.5, \"h\": 4}, \"x\": 8, \"y\": 2",
                                "\"w\": 1, \"h\": 0.5}, \"x\": 0.5, \"y\": 0.25");
        assertThat(leads(LevelTexts.level(elsewhere))).isEmpty();
    }

    @Test
    void clickThatOtherGamesWinByIsOneWhenItLosesFirst() {
        assertThat(leads(LevelTexts.level(PAST_THE_PLATFORM), "box")).containsExactly("box");
    }

    @Test
    void aBallLeftWhereNothingWinsIsLostOnlyIfDeadEndsCount() {
        Level level = LevelTexts.level(ONTO_A_SHELF);
        assertThat(leads(level)).isEmpty();
        assertThat(leads(level, FalseLeads.Losses.AND_DEAD_ENDS, Set.of())).containsExactly("box");
    }

    /** The shelf is a box as well, and without it the ball goes on to the platform. */
    @Test
    void aBallThatAnotherClickFreesIsInNoDeadEnd() {
        String shelf =
                LevelTexts.with("\"y\": 2.7", "\"y\": 4.7")
                        .replace("\"y\": 1.85", "\"y\": 3.85")
                        .replace(
                                "\"w\": 0.5, \"h\": 4}, \"x\": 8, \"y\": 2",
                                "\"w\": 2, \"h\": 1}, \"x\": 4.5, \"y\": 2.85")
                        .replace("\"dynamic\": false", "\"dynamic\": false, \"deletable\": true");
        assertThat(leads(LevelTexts.level(shelf), FalseLeads.Losses.AND_DEAD_ENDS, Set.of()))
                .isEmpty();
    }
}
