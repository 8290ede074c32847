package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.List;

/** Surfaces that are solid on one side. */
class OneWayTest {

    private static final double DT = 1 / 60.0;
    private static final Effects AWAKE = Effects.usual().without(Sleep.class);
    private static final Material SHELF = Material.DEFAULT.oneWay(0, 3);

    private static final List<Shape> SHAPES =
            List.of(
                    new Circle(0.2),
                    Polygon.box(0.5, 0.4),
                    new Capsule(0.2, 0.1),
                    Compound.of(
                            Part.of(Polygon.box(0.2, 0.6)),
                            Part.of(new Circle(0.15)).at(0.2, -0.2)));

    private static RigidBody shelf(Pool pool) {
        return pool.add(BodyDefinition.fixed(Polygon.box(4, 0.2)).material(SHELF));
    }

    /** The same flight without the shelf, to the bit. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1, 5, 17.3, 50})
    void whatComesFromBelowIsNotTouched(double speed) {
        for (Shape shape : SHAPES) {
            Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
            Pool empty = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
            shelf(pool);
            BodyDefinition rising = BodyDefinition.dynamic(shape).at(0.1, -1).velocity(0.01, speed);
            RigidBody body = pool.add(rising);
            RigidBody alone = empty.add(rising);
            while (body.y() < 1) {
                pool.step(DT);
                empty.step(DT);
                assertThat(body.velocityX()).isEqualTo(0.01);
                assertThat(body.velocityY()).isEqualTo(speed);
                assertThat(body.y()).isEqualTo(alone.y());
                assertThat(pool.contactEvents()).allMatch(contact -> contact.impulse() == 0);
            }
            body.velocity(0, -1);
            for (int i = 0; i < 90; i++) {
                pool.step(DT);
            }
            assertThat(body.y()).as("stopped by the shelf from above").isGreaterThan(0);
        }
    }

    /** Up through the shelf, and down on it: v²/2g = 1.27 m is more than enough. */
    @Test
    void whatWasThrownUpThroughItComesToRestOnIt() {
        for (Shape shape : SHAPES) {
            Pool pool = new Pool(AWAKE, Accuracy.GAME);
            RigidBody shelf = shelf(pool);
            RigidBody body = pool.add(BodyDefinition.dynamic(shape).at(0, -0.6).velocity(0, 6));
            for (int i = 0; i < 300; i++) {
                pool.step(DT);
            }
            assertThat(pool.touching(body, shelf)).as("%s", shape).isTrue();
            assertThat(Math.hypot(body.velocityX(), body.velocityY())).isLessThan(0.01);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 20, 400})
    void nothingPassesFromAbove(double speed) {
        for (Shape shape : SHAPES) {
            Pool pool = new Pool(AWAKE, Accuracy.GAME);
            pool.add(BodyDefinition.fixed(Polygon.box(60, 0.2)).material(SHELF));
            RigidBody body = pool.add(BodyDefinition.dynamic(shape).at(0, 2).velocity(0, -speed));
            for (int i = 0; i < 90; i++) {
                pool.step(DT);
                assertThat(body.y()).as("%s at %s", shape, body).isGreaterThan(0);
            }
        }
    }

    /** It stands across the plane beside the shelf, and is driven into it. */
    @Test
    void whatComesFromTheSidePasses() {
        Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
        shelf(pool);
        RigidBody body =
                pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(-4, 0.3).velocity(3, 0));
        for (int i = 0; i < 180; i++) {
            pool.step(DT);
            assertThat(body.velocityX()).isEqualTo(3);
        }
        assertThat(body.x()).isGreaterThan(4);
    }

    /** A lift that turns over: its normal turns with it, and what lay on it lies on it no more. */
    @Test
    void theNormalTurnsWithTheBody() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(4, 0.2)).angle(Math.PI).material(SHELF));
        RigidBody falls = pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, 1));
        RigidBody strikes =
                pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(1, -1).velocity(0, 9));
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
            assertThat(strikes.y()).as("solid from below").isLessThan(-0.29);
        }
        assertThat(falls.y()).isLessThan(-1);
    }

    /** One of the two is placed anew across the shelf: then it does not lie on its side. */
    @Test
    void isDecidedAnewForWhatIsPlacedAnew() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        RigidBody shelf = shelf(pool);
        RigidBody body = pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(0, 0.35));
        for (int i = 0; i < 10; i++) {
            pool.step(DT);
        }
        assertThat(pool.touching(body, shelf)).isTrue();
        body.moveTo(0, 0.2, 0);
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
        }
        assertThat(body.y()).isLessThan(-1);
    }

    @Test
    void goesOnFromASnapshotToTheBit() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        shelf(pool);
        RigidBody body = pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.4)).at(0, -0.5));
        body.velocity(0.2, 5);
        for (int i = 0; i < 5; i++) {
            pool.step(DT);
        }
        Pool copy = Pool.restore(pool.snapshot());
        for (int i = 0; i < 120; i++) {
            pool.step(DT);
            copy.step(DT);
            assertThat(copy.stateHash()).isEqualTo(pool.stateHash());
        }
        assertThat(body.y()).isEqualTo(0.3, within(0.001));
    }

    /** The material may come and go while something lies on it. */
    @Test
    void changesWithTheMaterial() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        RigidBody shelf = pool.add(BodyDefinition.fixed(Polygon.box(4, 0.2)));
        RigidBody body = pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, 0.3));
        pool.step(DT);
        shelf.material(Material.DEFAULT.oneWay(0, -1));
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
        }
        assertThat(body.y()).isLessThan(-0.5);
    }

    @Test
    void refusesANormalOfNoLength() {
        assertThatThrownBy(() -> Material.DEFAULT.oneWay(0, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Material.oneWay");
        assertThatThrownBy(() -> new Material(1, 0, 0, 0, 0, 0, 1, 1))
                .hasMessageContaining("unit vector");
        assertThat(SHELF.oneWayY()).isEqualTo(1);
        assertThat(SHELF.friction(0.1).isOneWay()).isTrue();
    }
}
