package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.SensorEvent.Phase;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Consumer;

/** Shapes that touch nothing and tell who is inside. */
class SensorsTest {

    private static final double DT = 1 / 60.0;
    private static final Effects SENSING = Effects.usual().with(new Sensors());
    private static final Effects AWAKE = SENSING.without(Sleep.class);

    private static RigidBody gate(Pool pool, double x, double y) {
        return pool.add(BodyDefinition.fixed(Polygon.box(0.2, 1)).at(x, y).sensor());
    }

    private static List<Phase> phases(Pool pool) {
        return pool.sensorEvents().stream().map(SensorEvent::phase).toList();
    }

    @Test
    void tellsWhoEntersStaysAndLeaves() {
        Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
        RigidBody coin = pool.add(BodyDefinition.fixed(new Circle(1)).sensor());
        RigidBody body =
                pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(-3.01, 0).velocity(3, 0));
        List<Phase> seen = new ArrayList<>();
        for (int i = 0; i < 150; i++) {
            pool.step(DT);
            boolean isInside = Math.hypot(body.x(), body.y()) <= 1.5;
            assertThat(pool.isInside(coin, body)).isEqualTo(isInside);
            assertThat(pool.inside(coin).contains(body)).isEqualTo(isInside);
            seen.addAll(phases(pool));
            assertThat(body.velocityX()).isEqualTo(3);
            assertThat(pool.contactEvents()).isEmpty();
        }
        assertThat(seen.get(0)).isEqualTo(Phase.ENTERED);
        assertThat(seen.get(seen.size() - 1)).isEqualTo(Phase.LEFT);
        assertThat(seen.subList(1, seen.size() - 1)).containsOnly(Phase.INSIDE);
        // 3 m of the way lie inside, at 3 m/s: 60 steps end there, and one tells the end.
        assertThat(seen).hasSize(61);
    }

    /** It is 17 to 1,700 m away when the step ends. */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e4, 1e5})
    void aBulletThatPassesWithinOneStepEntersAndLeaves(double speed) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        RigidBody gate = gate(pool, 0, 0);
        RigidBody above = gate(pool, 0, 1.2);
        RigidBody bullet =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.01))
                                .at(-speed * DT / 2, 0)
                                .velocity(speed, 0));
        pool.step(DT);
        assertThat(pool.sensorEvents())
                .containsExactly(
                        new SensorEvent(gate, 0, bullet, 0, Phase.ENTERED),
                        new SensorEvent(gate, 0, bullet, 0, Phase.LEFT));
        assertThat(pool.inside(gate)).isEmpty();
        assertThat(pool.inside(above)).isEmpty();
        pool.step(DT);
        assertThat(pool.sensorEvents()).isEmpty();
    }

    /** Its way goes to the wall and back: the straight line from its start to its end does not. */
    @Test
    void followsTheWayThatIsFlownAndNotTheStraightLine() {
        Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
        RigidBody atWall = gate(pool, 0.8, 0);
        RigidBody behind = gate(pool, 1.8, 0);
        pool.add(BodyDefinition.fixed(Polygon.box(0.2, 9)).at(1.2, 0));
        var elastic = rigibo.backend.setup.Material.DEFAULT.elasticity(1);
        RigidBody ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.05))
                                .velocity(120, 0)
                                .material(elastic));
        pool.step(DT);
        assertThat(ball.velocityX()).isEqualTo(-120);
        assertThat(ball.x()).isLessThan(0.3);
        assertThat(phases(pool)).containsExactly(Phase.ENTERED, Phase.LEFT);
        assertThat(pool.sensorEvents().get(0).sensor()).isSameAs(atWall);
        assertThat(pool.inside(behind)).isEmpty();
    }

    /** A sensor that is carried, by a body it weighs nothing for. */
    @Test
    void aPartMayBeASensor() {
        Compound walker =
                Compound.of(
                        Part.of(new Capsule(0.3, 0.2)).angle(Math.PI / 2),
                        Part.of(Polygon.box(0.2, 0.1)).at(0, -0.55).sensor());
        assertThat(walker.massProperties(2)).isEqualTo(new Capsule(0.3, 0.2).massProperties(2));
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        RigidBody man = pool.add(BodyDefinition.dynamic(walker).at(0, 1).lockRotation());
        boolean wasInTheAir = false;
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
            wasInTheAir |= pool.inside(man).isEmpty();
        }
        assertThat(wasInTheAir).isTrue();
        assertThat(pool.inside(man)).containsExactly(floor);
        assertThat(pool.sensorEvents().get(0).part()).isEqualTo(1);
        assertThat(man.isSensor()).isFalse();
        man.applyImpulse(0, 4 * man.mass(), man.x(), man.y());
        for (int i = 0; i < 10; i++) {
            pool.step(DT);
        }
        assertThat(pool.inside(man)).isEmpty();
    }

    @Test
    void seesSleepersAndWhatStandsButNoSensorsAndWakesNobody() {
        Pool pool = new Pool(SENSING, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        RigidBody crate = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        RigidBody post = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 1)).at(2, 0.5));
        for (int i = 0; i < 120; i++) {
            pool.step(DT);
        }
        assertThat(crate.isAwake()).isFalse();
        RigidBody area = pool.add(BodyDefinition.fixed(Polygon.box(5, 0.5)).at(1, 0.5).sensor());
        gate(pool, 1, 0.5);
        pool.step(DT);
        assertThat(pool.inside(area)).containsExactlyInAnyOrder(crate, post);
        assertThat(crate.isAwake()).isFalse();
        pool.remove(area);
        pool.step(DT);
        assertThat(crate.isAwake()).isFalse();
    }

    /**
     * A visitor that is removed, moved, disabled or filtered out is reported as having left by the
     * next step.
     */
    @Test
    void tellsTheEndAlsoAfterAnEdit() {
        Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
        RigidBody area = pool.add(BodyDefinition.fixed(Polygon.box(9, 9)).sensor());
        List<RigidBody> bodies = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            bodies.add(pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(i - 2, 0)));
        }
        pool.step(DT);
        assertThat(pool.inside(area)).hasSize(5);
        pool.remove(bodies.get(0));
        bodies.get(1).moveTo(50, 0, 0);
        bodies.get(2).disable();
        bodies.get(3).filter(Filter.ALL.mask(0));
        pool.step(DT);
        assertThat(
                        pool.sensorEvents().stream()
                                .filter(e -> e.phase() == Phase.LEFT)
                                .map(SensorEvent::visitor))
                .containsExactlyInAnyOrderElementsOf(bodies.subList(0, 4));
        assertThat(pool.inside(area)).containsExactly(bodies.get(4));
        pool.step(DT);
        assertThat(phases(pool)).containsExactly(Phase.INSIDE);
        bodies.get(2).enable();
        bodies.get(3).filter(Filter.ALL);
        pool.step(DT);
        assertThat(pool.inside(area)).hasSize(3);
    }

    /** 10⁵ bodies in 1,000 pools, each pool against a list of all pairs. */
    @Test
    void agreesWithAListOfAllPairs() {
        for (int seed = 0; seed < 1000; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            Pool pool = new Pool(AWAKE, Accuracy.DRAFT);
            List<RigidBody> sensors = new ArrayList<>();
            for (int i = 0; i < 100; i++) {
                BodyDefinition body = random(random, i % 10 == 0);
                RigidBody added = pool.add(body);
                if (body.isSensor()) {
                    sensors.add(added);
                }
            }
            for (int step = 0; step < 3; step++) {
                pool.step(DT);
            }
            for (RigidBody sensor : sensors) {
                assertThat(new HashSet<>(pool.inside(sensor)))
                        .as("seed %d, %s", seed, sensor)
                        .isEqualTo(bruteForce(pool, sensor));
            }
        }
    }

    private static BodyDefinition random(SplittableRandom random, boolean isSensor) {
        Shape shape =
                switch (random.nextInt(4)) {
                    case 0 -> new Circle(random.nextDouble(0.1, 0.6));
                    case 1 -> Polygon.box(random.nextDouble(0.1, 1), random.nextDouble(0.1, 1));
                    case 2 -> new Capsule(random.nextDouble(0.1, 0.6), 0.1);
                    default ->
                            Compound.of(
                                    Part.of(Polygon.box(0.5, 0.1)),
                                    Part.of(new Circle(0.2)).at(0.3, 0));
                };
        BodyDefinition body =
                switch (random.nextInt(4)) {
                    case 0 -> BodyDefinition.fixed(shape);
                    case 3 -> BodyDefinition.fixed(chain(random));
                    case 1 -> BodyDefinition.kinematic(shape).velocity(random.nextDouble(-5, 5), 1);
                    default ->
                            BodyDefinition.dynamic(shape)
                                    .mass(1)
                                    .velocity(random.nextDouble(-20, 20), random.nextDouble(-9, 9));
                };
        int category = 1 << random.nextInt(3);
        int mask = random.nextInt(4) == 0 ? random.nextInt() : ~0;
        BodyDefinition placed =
                body.at(random.nextDouble(-6, 6), random.nextDouble(-6, 6))
                        .angle(random.nextDouble(7))
                        .filter(new Filter(category, mask, 0));
        return isSensor ? placed.sensor() : placed;
    }

    private static Chain chain(SplittableRandom random) {
        double edge = random.nextDouble(0.1, 1);
        return Chain.open(edge, 0, 0, random.nextDouble(-edge, edge), -edge, 0);
    }

    private static Set<RigidBody> bruteForce(Pool pool, RigidBody sensor) {
        Set<RigidBody> inside = new HashSet<>();
        for (RigidBody body : pool.bodies()) {
            boolean isSeen =
                    body != sensor && !body.isSensor() && sensor.filter().meets(body.filter());
            if (isSeen
                    && Geometry.gap(sensor.shape(), place(sensor), body.shape(), place(body)).gap()
                            <= 0) {
                inside.add(body);
            }
        }
        return inside;
    }

    private static Placement place(RigidBody body) {
        return Placement.at(body.x(), body.y()).angle(body.angle());
    }

    /** An edge of a chain is a line to a sensor, whichever side of it is matter. */
    @Test
    void seesAChainThatItCrossesAndNoneThatItLiesBehind() {
        for (double side : new double[] {1, -1}) {
            Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
            pool.add(BodyDefinition.fixed(Chain.open(5, 0, 0, 0.3, -5, 0)));
            BodyDefinition sensor = BodyDefinition.kinematic(Polygon.box(1, 0.4)).sensor();
            pool.add(sensor.at(-3, side).velocity(60, 0));
            RigidBody crossing = pool.add(sensor.at(2, side).velocity(0, -120 * side));
            List<SensorEvent> seen = new ArrayList<>();
            for (int i = 0; i < 5; i++) {
                pool.step(DT);
                seen.addAll(pool.sensorEvents());
            }
            assertThat(seen.stream().map(SensorEvent::sensor)).containsOnly(crossing);
            assertThat(seen.stream().map(SensorEvent::phase))
                    .containsExactly(Phase.ENTERED, Phase.LEFT);
        }
    }

    /** Far sensors ask nobody: work goes by who is near. */
    @Test
    void costsByWhoIsNear() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        for (int i = 0; i < 1000; i++) {
            pool.add(BodyDefinition.fixed(new Circle(0.3)).at(3 * i, 10).sensor());
        }
        for (int i = 0; i < 2000; i++) {
            pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(1.5 * i, i < 100 ? 10 : -9));
        }
        pool.step(DT);
        // Every second of the first hundred is inside of a sensor; the fixtures of its neighbours
        // end 0.7 m away from the next.
        assertThat(pool.sensorEvents()).hasSize(50);
        assertThat(pool.report().sensed()).isBetween(50, 100);
    }

    @Test
    void goesOnFromASnapshotToTheBit() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        for (int i = 0; i < 60; i++) {
            pool.add(random(new SplittableRandom(i), i % 6 == 0));
        }
        pool.step(DT);
        Pool copy = Pool.restore(pool.snapshot());
        for (int i = 0; i < 60; i++) {
            assertThat(copy.stateHash()).isEqualTo(pool.stateHash());
            assertThat(copy.sensorEvents().toString()).isEqualTo(pool.sensorEvents().toString());
            pool.step(DT);
            copy.step(DT);
        }
    }

    @Test
    void undeclaredASensorIsRefusedByName() {
        Pool pool = new Pool();
        BodyDefinition coin = BodyDefinition.fixed(new Circle(1)).sensor();
        assertThatThrownBy(() -> pool.add(coin))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("Sensors");
        Compound withSensor = Compound.of(Part.of(new Circle(1)), Part.of(new Circle(2)).sensor());
        assertThatThrownBy(() -> pool.add(BodyDefinition.dynamic(withSensor)))
                .hasMessageContaining("Sensors");
        assertThat(pool.bodies()).isEmpty();
        assertThatThrownBy(() -> Effects.of(new Sensors())).hasMessageContaining("Contacts");
        Pool sensing = new Pool(SENSING, Accuracy.GAME);
        assertThatThrownBy(() -> sensing.add(BodyDefinition.dynamic(new Circle(1)).sensor()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("BodyDefinition.mass");
    }

    /** No answer would look like that of sensors which see nobody. */
    @Test
    void undeclaredEveryQuestionIsRefusedByName() {
        Pool pool = new Pool();
        RigidBody body = pool.add(BodyDefinition.dynamic(new Circle(1)));
        Consumer<SensorView> reader = seen -> {};
        List<ThrowingCallable> questions =
                List.of(
                        pool::sensorEvents,
                        () -> pool.forEachSensorEvent(reader),
                        () -> pool.inside(body),
                        () -> pool.isInside(body, body));
        for (ThrowingCallable question : questions) {
            assertThatThrownBy(question)
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("needs the effect Sensors, which is not declared");
        }
        pool.effects(SENSING);
        assertThat(pool.inside(body)).isEmpty();
        pool.effects(Effects.usual());
        assertThatThrownBy(() -> pool.inside(body)).hasMessageContaining("Pool.inside");
    }

    /** A sensor changes no bit of what the bodies do that it sees. */
    @Test
    void theBodiesDoWhatTheyDoWithoutIt() {
        Pool plain = new Pool(Effects.usual(), Accuracy.GAME);
        Pool sensing = new Pool(SENSING, Accuracy.GAME);
        for (Pool pool : List.of(plain, sensing)) {
            pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
            for (int i = 0; i < 30; i++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                .at(i % 5 * 0.55 - 1, 0.3 + i / 5 * 0.6));
            }
        }
        sensing.add(BodyDefinition.fixed(Polygon.box(3, 3)).at(0, 1).sensor());
        for (int i = 0; i < 200; i++) {
            plain.step(DT);
            sensing.step(DT);
        }
        for (int i = 0; i < plain.bodies().size(); i++) {
            assertThat(sensing.bodies().get(i).x()).isEqualTo(plain.bodies().get(i).x());
            assertThat(sensing.bodies().get(i).y()).isEqualTo(plain.bodies().get(i).y());
        }
    }

    @Test
    void allocatesNothingOnceWarm() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(9, 2)).at(0, 1).sensor());
        for (int i = 0; i < 10; i++) {
            pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(i * 0.5 - 2, 3).velocity(0, -20));
        }
        int[] inside = new int[1];
        Consumer<SensorView> reader = seen -> inside[0]++;
        long bytes =
                Allocation.ofThirdRun(
                        () -> {
                            for (int i = 0; i < 500; i++) {
                                pool.step(DT);
                                pool.forEachSensorEvent(reader);
                            }
                        });
        assertThat(bytes).isEqualTo(0);
        assertThat(inside[0]).isGreaterThan(5000);
    }

    @Test
    void queriesDoNotSeeIt() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(new Circle(1)).sensor());
        pool.step(DT);
        assertThat(pool.bodyAt(0, 0)).isEmpty();
        assertThat(pool.rayCast(-5, 0, 5, 0)).isEmpty();
        assertThat(pool.nearest(0, 0, 9, Filter.ALL)).isEmpty();
        List<RigidBody> met = new ArrayList<>();
        pool.overlapping(new rigibo.backend.geometry.Aabb(-1, -1, 1, 1), met::add);
        assertThat(met).isEmpty();
    }
}
