package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** Forces of the caller's own, and towards a centre. */
class FieldTest {

    private static final double OMEGA = 2 * Math.PI;
    private static final Material ELASTIC = new Material(1, 0, 1);

    /** r″ = −s·r³ on a circle of the radius 1 turns with √s. */
    @Test
    void anyPowerOfTheDistancePulls() {
        Pool pool = new Pool(Effects.of(new CentralForce(0, 0, 4, 3)), Level.EXACT.accuracy);
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(1, 0).velocity(0, 2));
        Scenes.run(pool, 60);
        assertThat(ball.x()).isEqualTo(Math.cos(2), within(1e-9));
        assertThat(ball.y()).isEqualTo(Math.sin(2), within(1e-9));
    }

    /**
     * A ball on a spring whose centre is at an elastic wall: |cos ωt|. A hundred impacts, none of
     * them at a step's end, in which the path goes on from what it is at the impact.
     */
    @ParameterizedTest
    @EnumSource(Level.class)
    void pathGoesOnAfterAnImpact(Level level) {
        Pool pool =
                new Pool(
                        Effects.of(
                                new Contacts(),
                                new Restitution(),
                                new ContinuousImpacts(),
                                new CentralForce(0, 0, OMEGA * OMEGA, 1)),
                        level.accuracy);
        pool.add(BodyDefinition.fixed(Polygon.box(1, 4)).at(-0.6, 0).material(ELASTIC));
        RigidBody ball =
                pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(1, 0).material(ELASTIC));
        int impacts = 0;
        for (int i = 1; i <= 3000; i++) {
            impacts += pool.step(Scenes.DT).impacts();
            double truth = Math.abs(Math.cos(OMEGA * pool.time()));
            // An impact is taken ¼ of 1e-4 × 0.2 m early, and the way is twice that shorter, each
            // time.
            assertThat(ball.x()).as("step %d", i).isEqualTo(truth, within(level.limit(1e-7, 1e-3)));
        }
        assertThat(impacts).isEqualTo(100);
        assertThat(ball.x()).isEqualTo(1, within(level.limit(1e-9, 1e-5)));
    }

    /** A force on one body that is not finite puts that body to rest, and no other. */
    @Test
    void forceThatIsNotFinitePutsItsBodyToRest() {
        Field hole = new Field(at -> at.accelerate(0, at.x > 5 ? Double.NaN : 0));
        Pool pool = new Pool(Scenes.usualWithoutSleep().with(hole), Level.GAME.accuracy);
        Scenes.addFloor(pool);
        RigidBody well =
                pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(4.7, 0.5).velocity(-1, 0));
        RigidBody lost = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(5.7, 0.5));
        StepReport report = pool.step(Scenes.DT);
        assertThat(report.quarantined()).isEqualTo(1);
        assertThat(report.quarantined(0)).isSameAs(lost);
        Scenes.run(pool, 30);
        assertThat(well.x()).isBetween(4.0, 4.7);
        assertThat(well.y()).isEqualTo(0.5, within(1e-3));
        assertThat(lost.x()).isEqualTo(5.7);
    }

    /** A field may rise at any time: what lies still under it stays awake, and follows it then. */
    @Test
    void bodiesStayAwakeUnderAField() {
        Field lift = new Field(at -> at.accelerate(0, at.time < 3 ? 0 : 20));
        Pool pool =
                new Pool(
                        Scenes.usualWithoutSleep().with(new Sleep()).with(lift),
                        Level.GAME.accuracy);
        Scenes.addFloor(pool);
        RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        Scenes.run(pool, 180);
        assertThat(box.isAwake()).isTrue();
        assertThat(box.y()).isEqualTo(0.5, within(1e-3));
        Scenes.run(pool, 60);
        // ½·(20 − 9.81)·1² m, and what the step in which the field rises leaves open.
        assertThat(box.y()).isEqualTo(0.5 + 10.19 / 2, within(10.19 * Scenes.DT));
    }

    /** In a pile the field acts on every body at its own place: two boxes, each of twice g. */
    @Test
    void fieldActsInsidePiles() {
        Field heavier = new Field(at -> at.accelerate(0, -9.81));
        Pool pool =
                new Pool(
                        Effects.of(new Gravity(0, -9.81), new Contacts(), heavier),
                        Level.GAME.accuracy);
        RigidBody floor = Scenes.addFloor(pool);
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1.5));
        Scenes.run(pool, 120);
        double impulse = 0;
        for (ContactEvent event : pool.contactEvents()) {
            impulse += event.a() == floor || event.b() == floor ? event.impulse() : 0;
        }
        assertThat(impulse).isEqualTo(2 * 2 * 9.81 * Scenes.DT, within(1e-9));
    }
}
