package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Polygon;

import java.util.Locale;

class LevelReadingTest {

    private static final double ROUNDING = 1e-12;
    private static final String WALL = "{\"type\": \"box\", \"w\": 0.5, \"h\": 4}";
    private static final String TRIANGLE =
            "{\"type\": \"polygon\", \"points\": [[0,0], [0.9,0], [0,0.9]]}";

    @Test
    void whatAFileLeavesOutHasItsUsualValue() {
        Level level = LevelTexts.sound();
        assertThat(level.limits().contactGrace()).isEqualTo(0.25);
        assertThat(level.platform().height()).isEqualTo(0.3);
        assertThat(level.balls().get(0).substance()).isEqualTo(Substance.BALL);
        assertThat(level.bodies().get(0).isDynamic()).isTrue();
        assertThat(level.bodies().get(1).deletable()).isFalse();
        assertThat(level.world().effects().find(Gravity.class)).contains(new Gravity(0, -9.81));
    }

    @Test
    void titlesFallBackToEnglish() {
        Wording title = LevelTexts.sound().title();
        assertThat(title.in(Locale.GERMANY)).isEqualTo("Fall");
        assertThat(title.in(Locale.FRENCH)).isEqualTo("Drop");
    }

    /** The centroid of a triangle is the mean of its corners: (0.3, 0.3) from the right angle. */
    @Test
    void aPolygonIsPlacedByItsCentroid() {
        LevelBody body = LevelTexts.level(LevelTexts.with(WALL, TRIANGLE)).bodies().get(1);
        assertThat(body.x()).isCloseTo(8.3, within(ROUNDING));
        assertThat(body.y()).isCloseTo(2.3, within(ROUNDING));
    }

    /** Turned by 90° the offset (0.3, 0.3) becomes (-0.3, 0.3). */
    @Test
    void aTurnedPolygonTurnsAboutTheFilesPoint() {
        String text =
                LevelTexts.with(WALL, TRIANGLE).replace("\"y\": 2,", "\"y\": 2, \"angle\": 90,");
        LevelBody body = LevelTexts.level(text).bodies().get(1);
        assertThat(body.x()).isCloseTo(7.7, within(ROUNDING));
        assertThat(body.y()).isCloseTo(2.3, within(ROUNDING));
        assertThat(body.angle()).isCloseTo(Math.PI / 2, within(ROUNDING));
    }

    @Test
    void cornersMayGoRoundEitherWay() {
        String clockwise = "{\"type\": \"polygon\", \"points\": [[0,0], [0,0.9], [0.9,0]]}";
        LevelBody body = LevelTexts.level(LevelTexts.with(WALL, clockwise)).bodies().get(1);
        assertThat(((Polygon) body.shape()).area()).isCloseTo(0.405, within(ROUNDING));
        assertThat(body.x()).isCloseTo(8.3, within(ROUNDING));
    }

    @Test
    void theHashSeesEveryNumberOfPlayAndNoText() {
        long hash = LevelTexts.sound().hash();
        assertThat(LevelTexts.level(LevelTexts.with("Drop", "Fall down")).hash()).isEqualTo(hash);
        assertThat(LevelTexts.level(LevelTexts.with("\"x\": 8", "\"x\": 8.001")).hash())
                .isNotEqualTo(hash);
        assertThat(LevelTexts.level(LevelTexts.with("-9.81", "-9.8")).hash()).isNotEqualTo(hash);
    }

    @Test
    void onlyWhatCanMoveIsShiftedAside() {
        Level shifted = LevelTexts.sound().shiftedSideways(() -> 0.01);
        assertThat(shifted.bodies().get(0).x()).isEqualTo(4.51);
        assertThat(shifted.bodies().get(1).x()).isEqualTo(8);
        assertThat(shifted.balls().get(0).x()).isEqualTo(4.51);
        assertThat(shifted.platform()).isEqualTo(LevelTexts.sound().platform());
    }
}
