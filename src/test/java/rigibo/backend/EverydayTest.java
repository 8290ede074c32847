package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

/** Everyday calls of a game: the places of a body's points, drives, sleep, disabling. */
class EverydayTest {

    private static final double DT = 1 / 60.0;

    private final Pool pool = new Pool();

    private RigidBody add(BodyDefinition definition) {
        return pool.add(definition);
    }

    private void run(int steps) {
        for (int i = 0; i < steps; i++) {
            pool.step(DT);
        }
    }

    /** Steps that do not divide the time, and half a turn either way. */
    @ParameterizedTest
    @CsvSource({"1.5708, 1", "-1.5708, 0.51", "3.1415, 2.3", "0.2, 0.033", "-3, 0.0167"})
    void aDoorTurnsAboutItsHinge(double turn, double seconds) {
        double angle = 0.3;
        RigidBody door =
                add(
                        BodyDefinition.kinematic(Polygon.box(2, 0.2))
                                .angle(angle)
                                .at(5 + Math.cos(angle), 1 + Math.sin(angle)));
        double end = angle + turn;
        door.driveTo(5 + Math.cos(end), 1 + Math.sin(end), end, seconds);
        int steps = (int) Math.ceil(seconds / DT - 1e-9);
        for (int i = 1; i <= steps; i++) {
            pool.step(DT);
            double wanted = angle + turn * Math.min(1, i * DT / seconds);
            assertThat(door.angle()).isEqualTo(wanted, within(1e-12));
            assertThat(door.x()).isEqualTo(5 + Math.cos(wanted), within(1e-12));
            assertThat(door.y()).isEqualTo(1 + Math.sin(wanted), within(1e-12));
        }
        run(3);
        assertThat(door.angle()).isEqualTo(end, within(1e-12));
        assertThat(door.velocityX()).isZero();
        assertThat(door.angularVelocity()).isZero();
    }

    @Test
    void aLiftTakesItsLoadAlongAndStops() {
        RigidBody lift = add(BodyDefinition.kinematic(Polygon.box(2, 0.2)).at(0, -0.1));
        RigidBody load = add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(0, 0.25));
        run(120);
        assertThat(load.isAwake()).isFalse();
        lift.driveTo(0, 2.9, 0, 3);
        run(90);
        Pool restored = Pool.restore(pool.snapshot());
        assertThat(lift.y()).isEqualTo(1.4, within(1e-12));
        run(180);
        for (int i = 0; i < 180; i++) {
            restored.step(DT);
        }
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
        assertThat(lift.y()).isEqualTo(2.9, within(1e-12));
        assertThat(load.y()).isEqualTo(3.25, within(0.01));
        assertThat(load.isAwake()).isFalse();
    }

    @Test
    void anotherOrderEndsADrive() {
        RigidBody lift = add(BodyDefinition.kinematic(Polygon.box(2, 0.2)));
        lift.driveTo(0, 6, 0, 6);
        run(60);
        lift.velocity(1, 0);
        run(60);
        assertThat(lift.y()).isEqualTo(1, within(1e-12));
        assertThat(lift.x()).isEqualTo(1, within(1e-12));
        lift.driveTo(0, 0, 0, 1);
        lift.driveTo(3, 0, 0, 2);
        lift.moveTo(0, 0, 0);
        lift.velocity(0, 0);
        run(60);
        assertThat(lift.x()).isZero();
        lift.type(BodyType.DYNAMIC);
        assertThatThrownBy(() -> lift.driveTo(0, 0, 0, 1)).hasMessageContaining("kinematic");
        lift.type(BodyType.KINEMATIC);
        assertThatThrownBy(() -> lift.driveTo(0, 0, 0, 0)).hasMessageContaining("seconds");
        assertThatThrownBy(() -> lift.driveTo(1e12, 0, 0, 1)).hasMessageContaining("speed");
    }

    @Test
    void pointsOfTheBodyAndOfTheWorldAreEachOthersInverse() {
        RigidBody body =
                add(
                        BodyDefinition.dynamic(Polygon.box(1, 1))
                                .at(3, -2)
                                .angle(0.7)
                                .velocity(1, 2)
                                .spin(5));
        double x = body.worldX(0.4, -0.1);
        double y = body.worldY(0.4, -0.1);

        assertThat(x).isEqualTo(3 + 0.4 * Math.cos(0.7) + 0.1 * Math.sin(0.7), within(1e-15));
        assertThat(body.localX(x, y)).isEqualTo(0.4, within(1e-15));
        assertThat(body.localY(x, y)).isEqualTo(-0.1, within(1e-15));
        assertThat(body.velocityXAt(x, y)).isEqualTo(1 - 5 * (y + 2), within(1e-14));
        assertThat(body.velocityYAt(x, y)).isEqualTo(2 + 5 * (x - 3), within(1e-14));
    }

    @Test
    void betweenTwoStepsTheWayIsStraight() {
        Pool space = new Pool(Effects.usual().without(Gravity.class), Accuracy.GAME);
        RigidBody body = space.add(BodyDefinition.dynamic(new Circle(1)).velocity(6, 0).spin(12));
        RigidBody still = space.add(BodyDefinition.fixed(new Circle(1)).at(9, 9));
        assertThat(body.xAt(0.5)).as("before any step").isZero();
        space.step(DT);
        assertThat(body.xAt(0)).isEqualTo(0, within(1e-15));
        assertThat(body.xAt(0.25)).isEqualTo(0.025, within(1e-15));
        assertThat(body.angleAt(0.25)).isEqualTo(0.05, within(1e-15));
        assertThat(body.xAt(1)).isEqualTo(body.x());
        assertThat(still.yAt(0.5)).isEqualTo(9);
        body.moveTo(50, 0, 0);
        assertThat(body.xAt(0.5)).as("placed anew").isEqualTo(50);
    }

    @Test
    void whoIsPutToSleepHangsUntilItIsTouched() {
        RigidBody hanging = add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 5).velocity(3, 0));
        hanging.sleep();
        run(60);
        assertThat(hanging.y()).isEqualTo(5);
        assertThat(hanging.isAwake()).isFalse();
        RigidBody stone = add(BodyDefinition.dynamic(new Circle(0.2)).at(0.3, 6));
        run(60);
        assertThat(hanging.isAwake()).isTrue();
        assertThat(hanging.y()).isLessThan(4.9);
        assertThat(stone.y()).isLessThan(5.8);
    }

    @Test
    void whoIsDisabledIsNotThere() {
        RigidBody shelf = add(BodyDefinition.fixed(Polygon.box(2, 0.2)).at(0, 1));
        RigidBody box = add(BodyDefinition.dynamic(Polygon.box(0.4, 0.4)).at(0, 1.3));
        run(120);
        assertThat(box.isAwake()).isFalse();
        shelf.disable();
        shelf.disable();
        assertThat(shelf.isEnabled()).isFalse();
        assertThat(pool.bodyAt(0, 1)).isEmpty();
        assertThat(pool.rayCast(5, 1, -5, 1)).isEmpty();
        run(30);
        assertThat(box.velocityY()).isEqualTo(-9.81 * 0.5, within(1e-9));
        shelf.moveTo(0, -5, 0);
        Pool restored = Pool.restore(pool.snapshot());
        assertThat(restored.bodies().get(0).isEnabled()).isFalse();
        assertThat(restored.rayCast(5, -5, -5, -5)).isEmpty();

        shelf.enable();
        assertThat(pool.bodyAt(0, -5)).contains(shelf);
        box.disable();
        double y = box.y();
        run(30);
        assertThat(box.y()).isEqualTo(y);
        assertThat(box.velocityY()).isEqualTo(-9.81 * 0.5, within(1e-9));
        Aabb bounds = new Aabb();
        box.sizeFixture(bounds);
        assertThat(bounds.maxY - bounds.minY).isEqualTo(0.4, within(1e-12));
        box.enable();
        run(200);
        assertThat(box.y()).isEqualTo(-4.7, within(0.01));
        box.disable();
        pool.remove(box);
        run(1);
        assertThat(pool.bodies()).containsExactly(shelf);
    }

    /** Contacts that are declared later find a body that was away meanwhile. */
    @Test
    void absencesOutlastAChangeOfEffects() {
        RigidBody shelf = add(BodyDefinition.fixed(Polygon.box(2, 0.2)).at(0, 1));
        RigidBody box = add(BodyDefinition.dynamic(Polygon.box(0.4, 0.4)).at(0, 1.4));
        shelf.disable();
        pool.effects(Effects.of());
        run(2);
        pool.effects(Effects.usual().without(Sleep.class));
        run(10);
        assertThat(pool.touching(box, shelf)).isFalse();
        box.moveTo(0, 1.4, 0);
        box.velocity(0, 0);
        shelf.enable();
        run(60);
        assertThat(pool.touching(box, shelf)).isTrue();
    }

    @Test
    void aTagIsTheCallersOwn() {
        RigidBody body = add(BodyDefinition.dynamic(new Circle(1)));
        assertThat(body.tag()).isNull();
        body.tag("coin");
        assertThat(body.tag()).isEqualTo("coin");
        assertThat(Pool.restore(pool.snapshot()).bodies().get(0).tag()).isNull();
    }

    /** A right triangle's centroid is a third along each leg; 2 m away is its corner. */
    @Test
    void tellsWhereTheOriginOfAStatedFrameIs() {
        Pool pool = new Pool();
        Polygon wedge = Polygon.of(0, 0, 3, 0, 0, 1.5);
        double turn = 0.7;
        RigidBody body = pool.add(BodyDefinition.dynamic(wedge).at(5, 6).angle(turn));
        double x = 5 - Math.cos(turn) * 1 + Math.sin(turn) * 0.5;
        double y = 6 - Math.sin(turn) * 1 - Math.cos(turn) * 0.5;
        assertThat(body.originX()).isEqualTo(x, within(1e-14));
        assertThat(body.originY()).isEqualTo(y, within(1e-14));

        Compound eccentric =
                Compound.of(Part.of(new Circle(0.5)).at(2, 0), Part.of(new Circle(0.5)).at(4, 0));
        body.shape(eccentric);
        assertThat(body.originX()).isEqualTo(5 - 3 * Math.cos(turn), within(1e-14));
        assertThat(body.originY()).isEqualTo(6 - 3 * Math.sin(turn), within(1e-14));
        body.shape(eccentric.centredAt(0, 1));
        assertThat(body.originX()).isEqualTo(5 + Math.sin(turn), within(1e-14));

        body.shape(Polygon.box(1, 2));
        assertThat(body.originX()).isEqualTo(5);
        assertThat(body.originY()).isEqualTo(6);
    }

    /** Its fixture was just laid when it was disabled, which a snapshot tells. */
    @Test
    void aPoolWithADisabledBodyGoesOnAsItsSnapshot() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.dynamic(new Circle(0.5))).disable();
        Pool restored = Pool.restore(pool.snapshot());
        pool.step(1 / 60.0);
        restored.step(1 / 60.0);
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
    }
}
