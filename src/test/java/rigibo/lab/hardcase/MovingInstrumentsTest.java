package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.truth.Earth;

import java.util.List;

/** Tests of the instruments that judge scenes with much motion. */
class MovingInstrumentsTest {

    private static final double CLOSE = 1e-12;

    private final Pool pool = new Pool(Earth.space(), Preset.GAME.accuracy());

    private RigidBody disc(double x, double y) {
        return pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(x, y));
    }

    private static Trial trial() {
        return new Trial(Preset.GAME, Preset.DRAFT, Sampling.USUAL, body -> body, 1);
    }

    private static Measure measured(Trial trial, String name) {
        return trial.measures().stream()
                .filter(measure -> measure.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void whatJumpsThroughAnotherIsCounted() {
        RigidBody left = disc(0, 0);
        disc(3, 0.1);
        pool.add(BodyDefinition.fixed(Polygon.box(0.01, 4)).at(10, 0));
        Passages passages = new Passages(pool.bodies());
        assertThat(passages.count()).isZero();
        left.moveTo(6, 0, 0);
        assertThat(passages.count()).as("a disc").isEqualTo(1);
        left.moveTo(14, 0, 0);
        assertThat(passages.count()).as("a thin wall").isEqualTo(1);
        left.moveTo(14, 9, 0);
        left.moveTo(0, 9, 0);
        assertThat(passages.count()).as("over both").isZero();
    }

    /** A disc of 1 kg and 1/2 m at 1 m/s²: from 12 m to its lowest point at 2.5 m it has 10 J. */
    @Test
    void energyBeyondStartAndWorkIsAShareOfWhatCouldBeReleased() {
        RigidBody body = pool.add(BodyDefinition.dynamic(new Circle(0.5)).mass(1).at(0, 12));
        EnergyGuard guard = new EnergyGuard(pool.bodies(), new Gravity(0, -1), 0);
        assertThat(guard.beyond(pool.bodies(), 0)).isZero();
        body.moveTo(0, 2.5, 0);
        assertThat(guard.beyond(pool.bodies(), 0)).as("lost").isZero();
        body.moveTo(0, 13, 0);
        assertThat(guard.beyond(pool.bodies(), 0)).isCloseTo(0.1, within(CLOSE));
        guard.add(1);
        assertThat(guard.beyond(pool.bodies(), 0)).as("by work").isCloseTo(0, within(CLOSE));
        guard.add(-1);
        assertThat(guard.beyond(pool.bodies(), 0)).as("work undone").isCloseTo(0.1, within(CLOSE));
    }

    /**
     * From 1 m down past two kinks at 0.5 and 0 m that take a tenth of the energy of motion each: 1
     * − 0.05 = 0.95, 0.95 − 0.095 = 0.855; and back over the same two: 0.7695, 0.74255.
     */
    @Test
    void kinksTakeTheirShareOfMotion() {
        KinkedSlide slide = new KinkedSlide(new double[] {2, 0.5, 0, 2}, 0.1, 1, 1);
        List<Double> turns = slide.swings(0.1, 2);
        assertThat(turns.get(0)).isCloseTo(0.855, within(CLOSE));
        assertThat(turns.get(1)).isCloseTo(0.74255, within(CLOSE));
    }

    /** Neighbouring plates meet on the circle; the box's formula is the catalogue's for small δ. */
    @Test
    void platesMeetInKinksOnTheCircle() {
        PlateBowl bowl = new PlateBowl(5, 12, PlateBowl.LAPPED);
        double[] end = bowl.on(3, bowl.length() / 2, 0);
        double[] begin = bowl.on(4, -bowl.length() / 2, 0);
        assertThat(end[0]).isCloseTo(begin[0], within(CLOSE));
        assertThat(end[1]).isCloseTo(begin[1], within(CLOSE));
        assertThat(Math.hypot(end[0], end[1])).isCloseTo(5, within(CLOSE));
        assertThat(bowl.slope(bowl.plateAt(0.3))).isCloseTo(0.3, within(bowl.kink() / 2));
        double kink = 1e-4;
        double both = kink * kink * (2.0 / 3 + 0.7 * 0.7 / 6);
        assertThat(2 * FlatPlateBowl.cornerLoss(kink, 1, 0.7) / both).isCloseTo(1, within(1e-3));
    }

    /** 2 kg that are taken from 0 to 3 m/s by what goes at 3 m/s: 18 J, the rest becomes heat. */
    @Test
    void carrierWorksByTheMomentumItHandsOver() {
        WatchedPool watched = new WatchedPool(trial(), "", Earth.space());
        RigidBody carrier =
                watched.add(BodyDefinition.kinematic(Polygon.box(1, 1)).at(-9, 0).velocity(3, 0));
        RigidBody body = watched.add(BodyDefinition.dynamic(new Circle(0.5)).mass(2).at(9, 0));
        CarrierWork work = new CarrierWork(watched, carrier);
        body.velocity(3, 0);
        assertThat(work.ofStep()).isCloseTo(18, within(CLOSE));
        assertThat(work.ofStep()).isZero();
    }

    /** A disc of 2 kg that a wall throws back has its momentum from the wall, not the carrier. */
    @Test
    void whatAFixedWallGivesIsNoWork() {
        WatchedPool watched = new WatchedPool(trial(), "", Earth.space());
        RigidBody carrier =
                watched.add(BodyDefinition.kinematic(Polygon.box(1, 1)).at(-50, 0).velocity(3, 0));
        watched.add(BodyDefinition.fixed(Polygon.box(1, 9)).at(5, 0));
        watched.add(BodyDefinition.dynamic(new Circle(0.5)).mass(2).velocity(7, 0));
        CarrierWork work = new CarrierWork(watched, carrier);
        double sum = 0;
        while (watched.time() < 1) {
            watched.step();
            sum += work.ofStep();
        }
        assertThat(sum).isCloseTo(0, within(1e-9));
    }

    @Test
    void figureIsHeldToTheLimitOfItsPresetAndBelowTheFirstToNone() {
        Limits limits = new Limits(4, 3, 2, 1);
        assertThat(limits.of(Preset.DRAFT)).isEqualTo(4);
        assertThat(limits.of(Preset.FINE)).isEqualTo(2);
        assertThat(Limits.of(3, 1).of(Preset.DRAFT)).isEqualTo(3);
        Trial held = trial();
        held.measure("x", 3.5, "m", limits);
        assertThat(measured(held, "x").passes()).isFalse();
        Trial reporting = new Trial(Preset.DRAFT, Preset.GAME, Sampling.USUAL, body -> body, 1);
        reporting.measure("x", 3.5, "m", limits);
        assertThat(measured(reporting, "x").isReported()).isTrue();
    }

    @Test
    void samplesAreDrawnAnewBySeedAndStayTheSameForOne() {
        Sampling other = new Sampling(Sampling.Extent.FULL, 2);
        assertThat(Sampling.USUAL.of(List.of(1), List.of(1, 2))).containsExactly(1);
        assertThat(other.of(List.of(1), List.of(1, 2))).containsExactly(1, 2);
        long drawn = Sampling.USUAL.random(5).nextLong();
        assertThat(Sampling.USUAL.random(5).nextLong()).isEqualTo(drawn);
        assertThat(Sampling.USUAL.random(6).nextLong()).isNotEqualTo(drawn);
        assertThat(other.random(5).nextLong()).isNotEqualTo(drawn);
    }

    @Test
    void movingPileKeepsItsShapeAndItsFloorCarriesIt() {
        StagedScene stage = new StagedScene(trial(), Piles.moving(Commotions.settling(2, 0), 5));
        assertThat(stage.bodies()).allMatch(body -> body.velocityX() == 5);
        stage.step();
        assertThat(stage.bodies().get(0).x()).isCloseTo(5 * Trial.DT, within(CLOSE));
        assertThat(stage.dynamic()).hasSize(3);
    }
}
