package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.setup.SolveMethod;

import java.util.ArrayList;
import java.util.List;

/** Piles at rest, none of which sleeps: they stand still, and begin to move when something does. */
class RestTest {

    private static final double GRAVITY = 9.81;
    private static final int BOXES = 10;
    private static final int SECOND = 60;

    private static Pool stack(Preset preset, List<RigidBody> boxes) {
        Pool pool = new Pool(Scenes.usualWithoutSleep(), preset.accuracy);
        Scenes.addFloor(pool);
        for (int i = 0; i < BOXES; i++) {
            boxes.add(pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, i + 0.5)));
        }
        Scenes.run(pool, 2 * SECOND);
        return pool;
    }

    /**
     * A contact gives way by 10⁻¹⁰ of its load's speed, ten of them by some nanometres a second.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatRestsStaysInItsPlace(Preset preset) {
        List<RigidBody> boxes = new ArrayList<>();
        Pool pool = stack(preset, boxes);
        double height = boxes.get(BOXES - 1).y();
        Scenes.run(pool, SECOND);
        assertThat(boxes.get(BOXES - 1).y()).isEqualTo(height, within(1e-8));
    }

    /** The impulse of a step is that of all its substeps: weight times time. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatRestsCarriesItsLoadThroughTheWholeStep(Preset preset) {
        List<RigidBody> boxes = new ArrayList<>();
        Pool pool = stack(preset, boxes);
        pool.step(Scenes.DT);
        double weight = boxes.stream().mapToDouble(box -> box.mass() * GRAVITY).sum();
        double carried =
                pool.contactEvents().stream()
                        .filter(event -> event.a() != boxes.get(0) || event.b() != boxes.get(1))
                        .filter(event -> event.a() == boxes.get(0) || event.b() == boxes.get(0))
                        .mapToDouble(ContactEvent::impulse)
                        .sum();
        // The solver leaves at most 10⁻⁶ of the fastest speed, at DRAFT 10⁻⁵.
        assertThat(carried).isEqualTo(weight * Scenes.DT, within(1e-5 * weight * Scenes.DT));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatLosesItsSupportFallsAtOnce(Preset preset) {
        List<RigidBody> boxes = new ArrayList<>();
        Pool pool = stack(preset, boxes);
        RigidBody second = boxes.get(1);
        double height = second.y();
        pool.remove(boxes.get(0));
        pool.step(Scenes.DT);
        assertThat(second.velocityY()).isEqualTo(-GRAVITY * Scenes.DT, within(1e-8));
        double fallen = GRAVITY * Scenes.DT * Scenes.DT / 2;
        assertThat(height - second.y()).isEqualTo(fallen, within(1e-8));
    }

    /**
     * A wind that rises in the middle of a step moves a box on a smooth floor from then on: v = u(1
     * − e^(−kt)). Kicks know when it rose to within one of them, and are a step long at most.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void aGustWithinAStepMovesWhatRested(Preset preset) {
        double rises = (SECOND + 0.5) * Scenes.DT;
        double speed = 10;
        double drag = 2;
        Effects windy =
                Effects.of(
                        new Gravity(0, -GRAVITY),
                        new Contacts(),
                        new Rotation(),
                        new Drag(),
                        new Wind(speed, 0, time -> time < rises ? 0 : 1));
        Pool pool = new Pool(windy, preset.accuracy);
        Scenes.addFloor(pool);
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(1, 1))
                                .at(0, 0.5)
                                .material(Material.DEFAULT.drag(drag)));
        Scenes.run(pool, SECOND);
        assertThat(box.velocityX()).isZero();
        pool.step(Scenes.DT);
        double blown = speed * (1 - Math.exp(-drag * (pool.time() - rises)));
        double kick = Scenes.DT / preset.accuracy.substeps();
        assertThat(box.velocityX()).isEqualTo(blown, within(drag * speed * kick));
        assertThat(box.velocityX()).isPositive();
    }

    /** Rows are written where a pile is solved: not for what rests, and again when it is struck. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatRestsIsNotSolvedUntilSomethingHappens(Preset preset) {
        List<RigidBody> boxes = new ArrayList<>();
        Pool pool = stack(preset, boxes);
        assertThat(pool.step(Scenes.DT).rows()).isZero();
        RigidBody top = boxes.get(BOXES - 1);
        top.applyImpulse(top.mass(), 0, top.x(), top.y());
        assertThat(pool.step(Scenes.DT).rows()).isPositive();
        assertThat(top.velocityX()).isPositive();
    }

    /** A box on a slope of 20° holds by μ = 0.5 > tan 20°, and slides at g·(sin − μ·cos) by 0.1. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatLosesItsGripSlidesAtOnce(Preset preset) {
        double slope = Math.toRadians(20);
        Pool pool = new Pool(Scenes.usualWithoutSleep(), preset.accuracy);
        RigidBody ramp =
                pool.add(
                        BodyDefinition.fixed(Polygon.box(40, 2))
                                .at(Math.sin(slope), -Math.cos(slope))
                                .angle(slope)
                                .material(new Material(1, 0.5, 0)));
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(2, 0.5))
                                .at(-0.25 * Math.sin(slope), 0.25 * Math.cos(slope))
                                .angle(slope)
                                .material(new Material(1, 0.5, 0)));
        Scenes.run(pool, SECOND);
        assertThat(pool.step(Scenes.DT).rows()).isZero();
        ramp.material(new Material(1, 0.1, 0));
        box.material(new Material(1, 0.1, 0));
        Scenes.run(pool, SECOND);
        double sliding = GRAVITY * (Math.sin(slope) - 0.1 * Math.cos(slope));
        double speed = Math.hypot(box.velocityX(), box.velocityY());
        // Coulomb's force is constant: the scheme is exact but for what is left unsolved, 10⁻⁵.
        assertThat(speed).isEqualTo(sliding * SECOND * Scenes.DT, within(1e-4));
    }

    /**
     * A plank on two tips that are but 0.5 mm wide, and slope: each tip touches it in two points,
     * which are as good as one, and what it carries it carries at the nearer. Whichever of the two
     * that is, the torques add up to none, and the plank is not solved again.
     */
    @ParameterizedTest
    @ValueSource(doubles = {-0.02, 0.02})
    void whatLiesOnTwoPointsThatAreAsGoodAsOneRests(double slope) {
        Effects effects =
                Effects.of(
                        new Gravity(0, -GRAVITY), new Contacts(), new Rotation(), new Friction());
        Pool pool = new Pool(effects, Accuracy.GAME);
        double tip = 5e-4;
        pool.add(
                BodyDefinition.dynamic(Polygon.box(2.4, 0.2))
                        .at(0, 0.1 / Math.cos(slope))
                        .angle(slope));
        for (double x : new double[] {-1, 1}) {
            double y = Math.tan(slope) * x - Math.abs(Math.tan(slope)) * tip / 2 - 0.1;
            pool.add(BodyDefinition.fixed(Polygon.box(tip, 0.2)).at(x, y));
        }
        Scenes.run(pool, SECOND);

        assertThat(pool.step(1.0 / SECOND).rows()).isZero();
        int[] asked = {0};
        pool.forEachContact(
                contact -> {
                    int nearer = contact.separation[0] < contact.separation[1] ? 0 : 1;
                    assertThat(contact.points).isEqualTo(2);
                    assertThat(contact.force[nearer]).isPositive();
                    assertThat(contact.force[1 - nearer]).isZero();
                    asked[0]++;
                });
        assertThat(asked[0]).isEqualTo(2);
    }

    /**
     * 5,050 boxes of which each stands on two, loaded from above as no pass over contacts could
     * tell in one step: nobody moves, and the floor carries the weight of all.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void aPyramidOfAHundredStoreysRests(Preset preset) {
        int base = 100;
        Pool pool = new Pool(Scenes.usualWithoutSleep(), preset.accuracy);
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(120, 1)).at(0, -0.5));
        List<RigidBody> boxes = new ArrayList<>();
        for (int storey = 0; storey < base; storey++) {
            for (int i = 0; i < base - storey; i++) {
                double x = 1.0625 * (i - (base - storey - 1) / 2.0);
                boxes.add(pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(x, storey + 0.5)));
            }
        }
        Scenes.run(pool, 10);
        for (RigidBody box : boxes) {
            assertThat(box.velocityX()).isZero();
            assertThat(box.velocityY()).isZero();
            assertThat(box.y()).isEqualTo(Math.round(box.y() - 0.5) + 0.5);
        }
        double weight = boxes.stream().mapToDouble(box -> box.mass() * GRAVITY).sum();
        double carried = carriedBy(floor, pool);
        // Every body is held to 10⁻¹⁰ of its weight.
        assertThat(carried).isEqualTo(weight * Scenes.DT, within(1e-9 * weight * Scenes.DT));
    }

    /**
     * A crowd that fell together is solved by passes, which leave something everywhere: within ten
     * seconds it is held to round-off all the same, and takes no work from then on.
     */
    @ParameterizedTest
    @CsvSource({"12, 0.01", "20, 0.02"})
    void aPyramidThatFellTogetherRests(int base, double gap) {
        Pool pool = new Pool(Scenes.usualWithoutSleep(), Accuracy.GAME);
        Material dry = new Material(1, 0.6, 0);
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1)).material(dry);
        RigidBody floor =
                pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).material(dry).at(0, -0.5));
        for (int storey = 0; storey < base; storey++) {
            for (int i = 0; i < base - storey; i++) {
                double y = storey + 0.5 + (storey + 1) * gap;
                pool.add(box.at(i - (base - storey - 1) / 2.0, y));
            }
        }
        Scenes.run(pool, 600);
        pool.step(Scenes.DT);
        assertThat(pool.report().contactSolves()).isZero();
        assertThat(pool.report().multiplications()).isZero();
        double weight = base * (base + 1) / 2.0 * GRAVITY;
        double carried = carriedBy(floor, pool);
        // Every body is held to 10⁻⁹ of its weight.
        assertThat(carried).isEqualTo(weight * Scenes.DT, within(1e-8 * weight * Scenes.DT));
    }

    /** The impulse in N·s that a body carried in the last step. */
    private static double carriedBy(RigidBody body, Pool pool) {
        return pool.contactEvents().stream()
                .filter(event -> event.a() == body || event.b() == body)
                .mapToDouble(ContactEvent::impulse)
                .sum();
    }

    /**
     * A disc on a slope of 5° leans on a box that is taken away while it is about to sleep: it
     * rolls at ⅔·g·sin θ from then on, in whichever step the box goes. On the Moon, where a step
     * does not take it far enough to be seen to move.
     */
    @ParameterizedTest
    @ValueSource(ints = {25, 28, 29, 30, 31, 32, 40})
    void whatLosesItsSupportBeforeItSleepsRolls(int stepsBefore) {
        double slope = Math.toRadians(5);
        double gravity = 1.62;
        Pool pool = new Pool(Effects.usual().with(new Gravity(0, -gravity)), Accuracy.GAME);
        pool.add(
                BodyDefinition.fixed(Polygon.box(20, 1))
                        .at(-0.5 * Math.sin(slope), -0.5 * Math.cos(slope))
                        .angle(-slope));
        RigidBody disc =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.35))
                                .at(0.35 * Math.sin(slope), 0.35 * Math.cos(slope))
                                .material(new Material(600, 0.5, 0.1)));
        double beside = 0.35 + 0.25;
        RigidBody gate =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.7))
                                .at(
                                        beside * Math.cos(slope) + 0.35 * Math.sin(slope),
                                        0.35 * Math.cos(slope) - beside * Math.sin(slope))
                                .angle(-slope)
                                .material(new Material(500, 0.5, 0.05)));
        Scenes.run(pool, stepsBefore);
        pool.remove(gate);
        Scenes.run(pool, 2 * SECOND);
        double rolling = 2.0 / 3 * gravity * Math.sin(slope) * 2 * SECOND * Scenes.DT;
        double speed = Math.hypot(disc.velocityX(), disc.velocityY());
        // Rolling is exact up to the solver's residual; a body may settle by 10⁻⁵ of its width.
        assertThat(speed).isEqualTo(rolling, within(1e-4));
    }

    /**
     * A plank's end lies on a ledge by a hair, whichever way it leans: its two points there count
     * as one, the deeper, and what it carries is told of that one. Told of the other it would be
     * off by 10⁻⁴ of its torque, and the plank would be solved anew in every step.
     */
    @ParameterizedTest
    @ValueSource(doubles = {-0.0125, 0.0125})
    void whatLiesOnALedgeByAHairIsSolvedOnce(double angle) {
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        Pool pool = new Pool(Scenes.usualWithoutSleep(), Accuracy.GAME);
        // The plank's lower right corner is at (0.5, 0), and 0.8 m before it the disc is under it.
        pool.add(
                BodyDefinition.fixed(new Circle(0.1))
                        .at(0.5 - 0.8 * cos + 0.1 * sin, -0.8 * sin - 0.1 * cos));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 1)).at(0.99995, -0.5));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(1, 0.1))
                        .at(0.5 - 0.5 * cos - 0.05 * sin, 0.05 * cos - 0.5 * sin)
                        .angle(angle));
        Scenes.run(pool, 5 * SECOND);
        assertThat(pool.report().islands(SolveMethod.AT_REST)).isOne();
    }

    /**
     * Each step removes a share of an overlap, so that some of it always remains. Once a step
     * removes so little that the box counts as still, the island is not solved any more, whatever
     * the length of the step.
     */
    @ParameterizedTest
    @ValueSource(ints = {15, 30, 60, 120, 240, 1000})
    void whatHasComeOutOfAnOverlapIsNotSolvedAgain(int stepsPerSecond) {
        Pool pool = new Pool(Scenes.usualWithoutSleep(), Accuracy.GAME);
        Scenes.addFloor(pool);
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.499));
        for (int step = 0; step < 3 * stepsPerSecond; step++) {
            pool.step(1.0 / stepsPerSecond);
        }
        assertThat(pool.report().islands(SolveMethod.AT_REST)).isOne();
    }
}
