package rigibo.lab.precision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.lab.engine.Line;
import rigibo.lab.engine.Setting;

import java.util.List;

class FrontWordsTest {

    private static Point point(String name, Line line, double error, double cost) {
        return FakePoints.point(name, line, 0, Setting.USUAL_STEP, error, cost);
    }

    /** 4/2 = 2 and 9/2 = 4.5. What half a step does is no knob's doing, however cheap it be. */
    @Test
    void presetsOffTheFrontAreToldBesideWhatIsCheaper() {
        double half = Setting.USUAL_STEP / 2;
        List<Point> points =
                List.of(
                        point("DRAFT", Line.PRESETS, 1e-2, 1),
                        point("GAME", Line.PRESETS, 1e-4, 4),
                        point("FINE", Line.PRESETS, 1e-5, 9),
                        point("EXACT", Line.PRESETS, Double.NaN, 20),
                        point("substeps 2", Line.SUBSTEPS, 1e-5, 2),
                        FakePoints.point("step, 1/120 s", Line.STEP, half, half, 1e-9, 0.5));
        assertThat(FrontWords.of(Asked.of(FakePoints.PROBLEMS, points)))
                .isEqualTo(
                        "1 of 3 presets lie on the front of our own knobs at the game's step or,"
                                + " by median times, within 10 % of it; the others cost more than"
                                + " a setting that is at least as accurate: at R1 GAME 2.00 ×, FINE"
                                + " 4.50 × as much as “substeps 2”.");
    }
}
