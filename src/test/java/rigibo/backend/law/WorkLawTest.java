package rigibo.backend.law;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.SolveMethod;

/** What moves is solved with so much work for each of its rows, however many there are. */
class WorkLawTest {

    /** A contact solved once in a pass, in multiplications. */
    private static final double PASS = 60;

    /** Fall, pile up and settle. */
    private static final int STEPS = 240;

    private static final double DROP = 1.2;

    /**
     * Boxes in a trough. No step may take more than twice the passes it may be given: 32 in four
     * substeps and in the half kick that ends a step, more where a small island turns fast, and as
     * much again for elimination; in the mean a third of that, since most of a heap is quiet.
     */
    @ParameterizedTest
    @CsvSource({"DRAFT, 100, 256", "GAME, 50, 320", "GAME, 100, 160", "GAME, 200, 160"})
    void crowdTakesSoMuchWorkForEachContact(Preset preset, int count, double mostPasses) {
        Pool pool = crowd(preset, count);
        double all = 0;
        double rows = 0;
        for (int i = 0; i < STEPS; i++) {
            StepReport report = pool.step(RandomScene.DT);
            double work = PASS * report.contactSolves() + report.multiplications();
            // Normal and friction of a contact are two of the rows that are told.
            double contacts = report.rows() / 2.0;
            if (report.rows(SolveMethod.PASSES) > count) {
                assertThat(work).isLessThan(2 * PASS * mostPasses * contacts);
                all += work;
                rows += contacts;
            }
        }
        assertThat(rows).as("contacts asked").isGreaterThan(30 * count);
        assertThat(all / rows).isLessThan(PASS * mostPasses / 3 * 2);
    }

    private static Pool crowd(Preset preset, int count) {
        Draw draw = new Draw(count);
        double width = Math.max(3, Math.sqrt(0.45 * count));
        Pool pool = new Pool(new Pool().effects(), preset.accuracy);
        pool.add(BodyDefinition.fixed(Polygon.box(width + 4, 2)).at(0, -1));
        for (int side = -1; side <= 1; side += 2) {
            pool.add(BodyDefinition.fixed(Polygon.box(2, 400)).at(side * (width / 2 + 1), 0));
        }
        int columns = (int) (width / DROP);
        for (int i = 0; i < count; i++) {
            Polygon box = Polygon.box(draw.between(0.5, 0.9), draw.between(0.3, 0.7));
            double x = DROP * (i % columns - (columns - 1) / 2.0);
            pool.add(
                    BodyDefinition.dynamic(box)
                            .at(x, DROP * (1 + i / columns))
                            .angle(draw.between(0, 6)));
        }
        return pool;
    }
}
