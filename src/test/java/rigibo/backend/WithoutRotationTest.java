package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Bodies;

import java.util.stream.Stream;

/** Where rotation is not declared bodies only translate: no angular columns, no angular rows. */
class WithoutRotationTest {

    private static final Effects GRAVITY = Effects.of(new Gravity(0, -9.81));
    private static final Effects CONTACTS = GRAVITY.with(new Contacts());

    /** Forces by place and velocity, some of which turn what can be turned. */
    private static final Effects FORCES =
            GRAVITY.with(new Drag())
                    .with(new Thrust())
                    .with(new AirDrag(1.2, 1))
                    .with(new Buoyancy(1, 2, 3))
                    .with(new CentralForce(0, 2, 1, -2));

    /** All that has columns of turning, but rotation itself. */
    private static final Effects STRAIGHT =
            Effects.usual().with(new Thrust()).with(new AirDrag(1.2, 1)).without(Rotation.class);

    private static final int STEPS = 120;

    @Test
    void noColumnOfTurningIsThere() {
        Pool pool = new Pool(STRAIGHT, Accuracy.GAME);
        Bodies columns = pool.columns();
        assertThat(columns.spin).isNull();
        assertThat(columns.angularAcceleration).isNull();
        assertThat(columns.startAngle).isNull();
        assertThat(columns.inertia).isNull();
        assertThat(columns.inverseInertia).isNull();
        assertThat(columns.sweepRadius).isNull();
        assertThat(columns.stillAngle).isNull();
        assertThat(columns.torque).isNull();
        assertThat(columns.pullTurn).isNull();
        assertThat(columns.stillX).isNotNull();
        assertThat(columns.forceX).isNotNull();
        assertThat(columns.pullX).isNotNull();
        assertThat(pool.plan()).doesNotContain("turn");
    }

    @Test
    void columnsOfTurningComeWithRotation() {
        Pool pool = new Pool(STRAIGHT, Accuracy.GAME);
        int bits = pool.bitsPerBody();
        pool.effects(STRAIGHT.with(new Rotation()));
        Bodies columns = pool.columns();
        assertThat(columns.spin).isNotNull();
        assertThat(columns.stillAngle).isNotNull();
        assertThat(columns.torque).isNotNull();
        assertThat(columns.pullTurn).isNotNull();
        assertThat(pool.plan()).contains("mass, turning", "faces that turn");
        assertThat(pool.bitsPerBody() - bits).isEqualTo(9 * 64);
    }

    /** In flight and in piles, through impacts and under forces of all kinds. */
    static Stream<Effects> straight() {
        return Stream.of(
                GRAVITY,
                GRAVITY.with(new Drag()).with(new Thrust()),
                FORCES,
                CONTACTS,
                CONTACTS.with(new Friction()).with(new Sleep()),
                CONTACTS.with(new Restitution()).with(new Drag()),
                CONTACTS.with(new ContinuousImpacts()).with(new Restitution()),
                FORCES.with(new Contacts()).with(new ContinuousImpacts()).with(new Restitution()),
                STRAIGHT);
    }

    @ParameterizedTest
    @MethodSource("straight")
    void everythingMovesAndNothingTurns(Effects effects) {
        Pool pool = tumble(effects);
        double[] angles = angles(pool);
        Scenes.run(pool, STEPS);
        assertThat(angles(pool)).isEqualTo(angles);
        assertThat(pool.bodies()).allMatch(body -> body.angularVelocity() == 0);
        assertThat(pool.report().quarantined()).isZero();
        RigidBody last = pool.bodies().get(pool.bodies().size() - 1);
        assertThat(last.y()).isNotEqualTo(4);
    }

    @ParameterizedTest
    @MethodSource("straight")
    void goesOnFromASnapshotToTheSameBits(Effects effects) {
        Pool pool = tumble(effects);
        Scenes.run(pool, STEPS / 2);
        Pool restored = Pool.restore(pool.snapshot());
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
        Scenes.run(pool, STEPS / 2);
        Scenes.run(restored, STEPS / 2);
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
    }

    /** More bodies than there is room for at first, of which some are told to turn. */
    private static Pool tumble(Effects effects) {
        Pool pool = new Pool(effects, Accuracy.GAME);
        Scenes.addTray(pool);
        pool.add(BodyDefinition.kinematic(Polygon.box(3, 0.3)).at(2, 3).spin(1.3));
        Scenes.addMixture(pool, 18);
        RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(0.8, 0.8)).at(0, 4).spin(5));
        box.spin(3);
        box.applyImpulse(0, -0.1, 0.3, 4);
        return pool;
    }

    private static double[] angles(Pool pool) {
        return pool.bodies().stream().mapToDouble(RigidBody::angle).toArray();
    }

    /** Nothing here gives a moment: boxes that fall side by side. */
    static Stream<Effects> thatTurnNothing() {
        return Stream.of(
                GRAVITY,
                GRAVITY.with(new Drag()),
                GRAVITY.with(new Thrust()),
                GRAVITY.with(new AirDrag(1.2, 1)),
                CONTACTS,
                CONTACTS.with(new AirDrag(1.2, 1)).with(new ContinuousImpacts()),
                STRAIGHT);
    }

    @ParameterizedTest
    @MethodSource("thatTurnNothing")
    void rotationThatTurnsNothingEqualsUndeclaredToTheBit(Effects effects) {
        Pool plain = falling(effects);
        Pool neutral = falling(effects.with(new Rotation()));
        for (int step = 1; step <= STEPS; step++) {
            plain.step(Scenes.DT);
            neutral.step(Scenes.DT);
            assertThat(neutral.stateHash()).as("step %d", step).isEqualTo(plain.stateHash());
        }
    }

    private static Pool falling(Effects effects) {
        Pool pool = new Pool(effects, Accuracy.GAME);
        for (int i = 0; i < 20; i++) {
            pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.5)).at(3 * i, i).angle(0.1 * i));
        }
        return pool;
    }

    @Test
    void torqueAskedForIsNeitherFeltNorRemembered() {
        Pool pushed = new Pool(GRAVITY.with(new Thrust()), Accuracy.GAME);
        Pool turned = new Pool(GRAVITY.with(new Thrust()), Accuracy.GAME);
        pushed.add(Scenes.restingBox()).applyForce(2, 0, 0, 0.5);
        RigidBody box = turned.add(Scenes.restingBox());
        box.applyForce(2, 0, 0, 3);
        box.applyTorque(7);
        assertThat(turned.stateHash()).isEqualTo(pushed.stateHash());
        pushed.step(Scenes.DT);
        turned.step(Scenes.DT);
        assertThat(turned.stateHash()).isEqualTo(pushed.stateHash());
    }

    @Test
    void inertiaIsToldAndEnergyIsOfMotionAlone() {
        RigidBody box = new Pool(GRAVITY, Accuracy.GAME).add(turningBox());
        RigidBody free = new Pool(GRAVITY.with(new Rotation()), Accuracy.GAME).add(turningBox());
        assertThat(box.inertia()).isEqualTo(free.inertia());
        assertThat(box.angularMomentum()).isZero();
        assertThat(box.kineticEnergy()).isEqualTo(box.mass() * 4 / 2);
        assertThat(free.kineticEnergy()).isEqualTo((box.mass() * 4 + box.inertia() * 3 * 3) / 2);
    }

    private static BodyDefinition turningBox() {
        return Scenes.restingBox().velocity(2, 0).spin(3);
    }

    /** ω = r·J/I of an impact J at the arm r. */
    @Test
    void bodiesBeginToTurnFromRestWhenRotationIsDeclaredLater() {
        Pool pool = new Pool(GRAVITY, Accuracy.GAME);
        RigidBody stated = pool.add(turningBox().inertia(5));
        RigidBody plain = pool.add(turningBox());
        pool.step(Scenes.DT);
        pool.effects(GRAVITY.with(new Rotation()));
        assertThat(stated.angularVelocity()).isZero();
        assertThat(stated.inertia()).isEqualTo(5);
        assertThat(plain.inertia()).isEqualTo(turningBox().inertia());
        stated.applyImpulse(0, 2, stated.x() + 0.5, stated.y());
        plain.applyImpulse(0, 2, plain.x() + 0.5, plain.y());
        assertThat(stated.angularVelocity()).isCloseTo(0.2, offset(1e-12));
        assertThat(plain.angularVelocity()).isCloseTo(1 / plain.inertia(), offset(1e-12));
        pool.step(Scenes.DT);
        assertThat(stated.angle()).isCloseTo(0.2 * Scenes.DT, offset(1e-12));
    }

    @Test
    void bodiesKeepTheirAngleWhenRotationIsNoLongerDeclared() {
        Pool pool = new Pool(GRAVITY.with(new Rotation()), Accuracy.GAME);
        RigidBody box = pool.add(turningBox());
        pool.step(Scenes.DT);
        double angle = box.angle();
        assertThat(angle).isCloseTo(3 * Scenes.DT, offset(1e-12));
        pool.effects(GRAVITY);
        pool.step(Scenes.DT);
        assertThat(box.angle()).isEqualTo(angle);
        pool.effects(GRAVITY.with(new Rotation()));
        pool.step(Scenes.DT);
        assertThat(box.angle()).isEqualTo(angle);
        assertThat(box.angularVelocity()).isZero();
    }

    /** It went on as one that moves, among others in another order than in a restored pool. */
    @Test
    void whatOnlySpunStandsStillOnceNothingTurns() {
        Pool pool = new Pool(CONTACTS.with(new Rotation()), Accuracy.GAME);
        pool.add(BodyDefinition.kinematic(Polygon.box(1, 1)).spin(3));
        assertThat(pool.step(Scenes.DT).awake()).isEqualTo(1);
        pool.effects(CONTACTS);
        assertThat(pool.step(Scenes.DT).awake()).isZero();
    }
}
