package rigibo.backend.law;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Material;
import rigibo.backend.setup.SolveMethod;

/** The work for moving bodies is bounded for each of their rows, however many there are. */
@Execution(ExecutionMode.CONCURRENT)
class WorkLawTest {

    /** A contact solved once in a pass, in multiplications. */
    private static final double PASS = 60;

    /** Fall, pile up and settle. */
    private static final int STEPS = 240;

    private static final double DROP = 1.2;

    /** Multiplications that one island is worth, impacts and elimination, whatever it is. */
    private static final double SMALLEST = 1e6 + 1e5;

    private static final Effect[] CALLED_FOR = {
        new Gravity(0, -9.81),
        new Contacts(),
        new Rotation(),
        new Friction(),
        new Restitution(),
        new ContinuousImpacts()
    };

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

    /**
     * Among bodies of one mass that keep nothing of what they close with, an elimination is worth a
     * quarter of the passes. What is tiny, alone or calm, and impacts, may take as much again.
     */
    @ParameterizedTest
    @CsvSource({"DRAFT, 30", "DRAFT, 60", "GAME, 30", "GAME, 60"})
    void whatTumblesIsLeftToPasses(Preset preset, int count) {
        Pool pool = crowd(preset, count);
        double passes = 0;
        double eliminations = 0;
        for (int i = 0; i < STEPS / 2; i++) {
            StepReport report = pool.step(RandomScene.DT);
            passes += PASS * report.contactSolves();
            eliminations += report.multiplications();
        }
        assertThat(passes).as("work of passes").isGreaterThan(PASS * STEPS * count);
        assertThat(eliminations).isLessThan(passes / 2);
    }

    /**
     * Twelve boxes of up to two hundred times each other's mass, smooth and rough. Elimination may
     * take a hundred times the work of passes there, which solve each contact six times in each
     * kick; the passes between eliminations take no more. Some of these heaps never converge.
     */
    @Test
    void roundsThatDoNotConvergeEnd() {
        int kicks = Preset.GAME.accuracy.substeps() + 1;
        long most = 100L * 6 * kicks;
        long longest = 0;
        for (long seed = 1; seed <= 60; seed++) {
            Pool pool = unlike(new Draw(seed), seed % 2 == 0 ? 0 : 0.3);
            for (int i = 0; i < STEPS / 2; i++) {
                StepReport report = pool.step(RandomScene.DT);
                long each = report.contactSolves() / Math.max(1, report.contacts());
                assertThat(each).as("seed %d, step %d", seed, i).isLessThan(most);
                longest = Math.max(longest, each);
            }
        }
        assertThat(longest).as("solutions of a contact in a step").isGreaterThan(most / 10);
    }

    private static Pool unlike(Draw draw, double friction) {
        Pool pool = new Pool(new Pool().effects(), Preset.GAME.accuracy);
        Material material = new Material(1, friction, 0);
        pool.add(BodyDefinition.fixed(Polygon.box(8, 1)).at(0, -0.5).material(material));
        for (int side = -1; side <= 1; side += 2) {
            BodyDefinition wall = BodyDefinition.fixed(Polygon.box(1, 6));
            pool.add(wall.at(side * 2.5, 3).material(material));
        }
        for (int i = 0; i < 12; i++) {
            double size = draw.between(0.25, 0.75);
            Polygon box = Polygon.box(size, size * draw.between(0.5, 1.5));
            pool.add(
                    BodyDefinition.dynamic(box)
                            .at(i % 4 - 1.5, 0.6 + i / 4)
                            .angle(draw.between(0, 6))
                            .material(material.density(draw.ofAnySize(20, 2000))));
        }
        return pool;
    }

    /**
     * Elastic discs on discs: what an impact goes through is the whole heap. Impacts and
     * elimination may each take 18 passes over all points a kick, but for small islands, whose
     * impacts may take one million multiplications a step; what is eliminated because it is calm
     * may take sixteen times that, once.
     */
    @Test
    void impactsInAHeapOfDiscsAreWithinABudget() {
        Pool pool = new Pool(Effects.of(CALLED_FOR), Preset.GAME.accuracy);
        pool.add(BodyDefinition.fixed(Polygon.box(20, 2)).at(0, -1));
        for (int side = -1; side <= 1; side += 2) {
            pool.add(BodyDefinition.fixed(Polygon.box(2, 400)).at(side * 6, 0));
        }
        Draw draw = new Draw(1);
        Material lively = new Material(1, 0.3, 0.4);
        for (int i = 0; i < 300; i++) {
            double x = 0.62 * (i % 16 - 7.5) + draw.between(-0.05, 0.05);
            BodyDefinition disc = BodyDefinition.dynamic(new Circle(draw.between(0.2, 0.28)));
            pool.add(disc.at(x, 0.4 + 0.7 * (i / 16)).material(lively));
        }
        int kicks = Preset.GAME.accuracy.substeps() + 1;
        long impacts = 0;
        for (int i = 0; i < STEPS; i++) {
            StepReport report = pool.step(RandomScene.DT);
            double contacts = report.rows() / 2.0;
            double ofImpacts = 18 * PASS * contacts;
            double calm = 16 * ofImpacts;
            int solved =
                    report.islands(SolveMethod.ELIMINATION) + report.islands(SolveMethod.PASSES);
            double most = kicks * (ofImpacts + calm) + SMALLEST * solved;
            assertThat(report.multiplications()).isLessThanOrEqualTo(most);
            impacts += report.impacts();
        }
        assertThat(impacts).isGreaterThan(1_000);
    }

    /**
     * Between a wall and what is driven against it no load is enough: passes would go on for ever.
     * But what is driven presses with no more than what throws both boxes at 8 times its speed, and
     * each pass adds at least a tenth of what throws one of them at that speed.
     */
    @Test
    void passesEndWhateverAnAccuracyAsksFor() {
        Accuracy most = Accuracy.GAME.withSubsteps(64).withVelocityIterations(8);
        Pool pool = new Pool(new Pool().effects(), most.withContactSolver(ContactSolver.BLOCK));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 4)).at(-0.5, 0));
        pool.add(BodyDefinition.kinematic(Polygon.box(1, 4)).at(2.5, 0).velocity(-1, 0));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0.5, 0));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(1.5, 0));
        StepReport report = pool.step(RandomScene.DT);
        assertThat(report.contactSolves())
                .isBetween(65L * report.contacts(), 160L * 65 * report.contacts());
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
