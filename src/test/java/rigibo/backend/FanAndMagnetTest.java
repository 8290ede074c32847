package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;

/** Streams of air and magnets, whose forces fall linearly along their reach, in closed form. */
class FanAndMagnetTest {

    private static final double DT = 1.0 / 60;
    private static final double MASS = 3;
    private static final double REACH = 5;
    private static final double FORCE = 30;

    /** Upwards from the origin, 4 m wide. */
    private static final Fan.Jet JET = new Fan.Jet(0, 0, Math.PI / 2, 4, REACH, FORCE);

    private static final int IRON = 1 << 1;
    private static final Magnet.Pole POLE = new Magnet.Pole(0, 0, 8, REACH, IRON);

    /** The presets, since a JUnit enum source needs an enum, and what each may be off by, m. */
    enum Preset {
        DRAFT(Accuracy.DRAFT, 2e-3),
        GAME(Accuracy.GAME, 1e-6),
        FINE(Accuracy.FINE, 1e-8),
        EXACT(Accuracy.EXACT, 1e-9);

        final Accuracy accuracy;
        final double tolerance;

        Preset(Accuracy accuracy, double tolerance) {
            this.accuracy = accuracy;
            this.tolerance = tolerance;
        }
    }

    private static Pool pool(Accuracy accuracy, Effect... effects) {
        return new Pool(Effects.of(effects), accuracy);
    }

    private static BodyDefinition box(double x, double y) {
        return BodyDefinition.dynamic(Polygon.box(0.5, 0.8)).mass(MASS).at(x, y);
    }

    private static void steps(Pool pool, int count) {
        for (int i = 0; i < count; i++) {
            pool.step(DT);
        }
    }

    /**
     * m·s″ = f·b·(1 − s/R): the distance d = R − s to the stream's end swings as d₀·cos ωt with ω²
     * = f·b/(m·R), until it is 0.
     */
    @ParameterizedTest
    @EnumSource
    void aStreamPushesByTheWidthItMeets(Preset at) {
        Pool pool = pool(at.accuracy, new Fan(JET));
        RigidBody body = pool.add(box(0.3, 1));
        steps(pool, 60);
        double omega = Math.sqrt(FORCE * 0.5 / (MASS * REACH));
        assertThat(body.y()).isCloseTo(REACH - 4 * Math.cos(omega), within(at.tolerance));
        assertThat(body.x()).isCloseTo(0.3, within(1e-12));
        assertThat(body.angularVelocity()).isZero();
    }

    /** Turned by a quarter, the box of 0.5 m × 0.8 m is 0.8 m wide to the stream. */
    @Test
    void aTurnedBodyIsAsWideAsItLies() {
        Pool pool = pool(Accuracy.EXACT, new Fan(JET), new Rotation());
        RigidBody body = pool.add(box(0, 1).angle(Math.PI / 2));
        steps(pool, 60);
        double omega = Math.sqrt(FORCE * 0.8 / (MASS * REACH));
        assertThat(body.y()).isCloseTo(REACH - 4 * Math.cos(omega), within(1e-9));
    }

    /** Half of a disc of radius 1 m whose middle is at the stream's edge is within it: 1 m. */
    @Test
    void onlyWhatIsWithinTheStreamIsPushed() {
        Pool pool = pool(Accuracy.EXACT, new Fan(JET));
        RigidBody body = pool.add(BodyDefinition.dynamic(new Circle(1)).mass(MASS).at(2, 1));
        steps(pool, 60);
        double omega = Math.sqrt(FORCE * 1 / (MASS * REACH));
        assertThat(body.y()).isCloseTo(REACH - 4 * Math.cos(omega), within(1e-9));
    }

    /** Where f·b·(1 − s/R) = m·g a body hovers: the force there is its weight, to the last bits. */
    @Test
    void aBodyHoversWhereTheStreamBearsItsWeight() {
        double gravity = 2;
        double height = REACH * (1 - MASS * gravity / (FORCE * 0.5));
        Pool pool = pool(Accuracy.GAME, new Fan(JET), new Gravity(0, -gravity));
        RigidBody body = pool.add(box(0, height));
        steps(pool, 600);
        assertThat(body.y()).isCloseTo(height, within(1e-9));
    }

    /** Behind the mouth, beside the stream and beyond its reach: the same bits as without it. */
    @Test
    void aStreamIsLocal() {
        Pool with = pool(Accuracy.GAME, new Fan(JET), new Gravity(0.1, 0));
        Pool without = pool(Accuracy.GAME, new Fan(JET.force(0)), new Gravity(0.1, 0));
        for (Pool pool : new Pool[] {with, without}) {
            pool.add(box(0, -0.1));
            pool.add(box(3, 1));
            pool.add(box(-1, REACH + 0.1));
            steps(pool, 60);
        }
        for (int i = 0; i < 3; i++) {
            assertThat(with.bodies().get(i).x()).isEqualTo(without.bodies().get(i).x());
            assertThat(with.bodies().get(i).y()).isEqualTo(without.bodies().get(i).y());
        }
    }

    /** Its strength is changed between steps: from then on the swing is that of half the force. */
    @Test
    void theStrengthCanBeChangedWhileItRuns() {
        Pool pool = pool(Accuracy.EXACT, new Fan(JET));
        RigidBody body = pool.add(box(0, 1));
        steps(pool, 30);
        double away = REACH - body.y();
        double speed = -body.velocityY();
        pool.effects(pool.effects().with(new Fan(JET.force(FORCE / 2))));
        steps(pool, 30);
        double omega = Math.sqrt(FORCE / 2 * 0.5 / (MASS * REACH));
        double t = 0.5;
        double then = away * Math.cos(omega * t) + speed / omega * Math.sin(omega * t);
        assertThat(body.y()).isCloseTo(REACH - then, within(1e-9));
    }

    /** A body asleep in a stream wakes when the stream is switched on. */
    @Test
    void aStreamThatIsSwitchedOnWakesWhatSleeps() {
        Gravity gravity = new Gravity(0, -10);
        Pool pool =
                pool(Accuracy.GAME, gravity, new Contacts(), new Sleep(), new Fan(JET.force(0)));
        pool.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(0, 0.5));
        RigidBody body = pool.add(box(0, 1.4));
        steps(pool, 240);
        assertThat(body.isAwake()).isFalse();
        pool.effects(pool.effects().with(new Fan(JET.force(400))));
        steps(pool, 30);
        assertThat(body.y()).isGreaterThan(1.5);
    }

    /**
     * r″ = −s·(1 − r/R): the distance d = R − r to the reach's end grows as d₀·cosh ωt with ω² =
     * s/R, whatever the mass.
     */
    @ParameterizedTest
    @EnumSource
    void aMagnetPullsWhatIsOfItsCategory(Preset at) {
        Pool pool = pool(at.accuracy, new Magnet(POLE));
        Filter iron = Filter.ALL.category(1 | IRON);
        RigidBody body = pool.add(box(-2.4, 1.8).filter(iron));
        RigidBody wood = pool.add(box(2, 2));
        steps(pool, 36);
        double away = (REACH - 3) * Math.cosh(Math.sqrt(8 / REACH) * 36 * DT);
        assertThat(Math.hypot(body.x(), body.y())).isCloseTo(REACH - away, within(at.tolerance));
        assertThat(body.x() / body.y()).isCloseTo(-2.4 / 1.8, within(1e-9));
        assertThat(wood.x()).isEqualTo(2);
        assertThat(wood.y()).isEqualTo(2);
    }

    @Test
    void aMagnetActsNeitherBeyondItsReachNorAtItsOwnPlace() {
        Pool pool = pool(Accuracy.GAME, new Magnet(new Magnet.Pole(0, 0, 8, REACH)));
        RigidBody there = pool.add(box(0, 0));
        RigidBody far = pool.add(box(REACH, 0));
        steps(pool, 60);
        assertThat(there.x()).isZero();
        assertThat(far.x()).isEqualTo(REACH);
    }

    @Test
    void bothAreSavedWithoutTheCallersHelpAndGoOnToTheSameBits() {
        Fan.Jet other = new Fan.Jet(1, 2, 0.3, 0.5, 2, -7);
        Pool pool = pool(Accuracy.GAME, new Fan(JET, other), new Magnet(POLE), new Rotation());
        pool.add(box(0, 1).filter(Filter.ALL.category(IRON)));
        pool.add(box(0.2, 3).spin(1));
        steps(pool, 20);
        Pool restored = Pool.restore(pool.snapshot());
        assertThat(restored.effects()).isEqualTo(pool.effects());
        steps(pool, 40);
        steps(restored, 40);
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
    }

    @Test
    void numbersOutOfRangeAreRefusedByName() {
        assertThatThrownBy(() -> new Fan.Jet(0, 0, 0, 0, 1, 1)).hasMessageContaining("width");
        assertThatThrownBy(() -> new Fan.Jet(0, 0, Double.NaN, 1, 1, 1))
                .hasMessageContaining("angle");
        assertThatThrownBy(() -> new Magnet.Pole(0, 0, 1, -1)).hasMessageContaining("reach");
        assertThatThrownBy(() -> new Fan((Fan.Jet) null)).hasMessageContaining("jet");
    }
}
