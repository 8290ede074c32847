package rigibo.backend.impact;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** The values that an impact reads from the columns, and those it writes back. */
class ImpactColumnsTest {

    private static BodyDefinition disc(double mass, double friction, double elasticity) {
        return BodyDefinition.dynamic(new Circle(1))
                .mass(mass)
                .inertia(mass / 2)
                .material(new Material(1, friction, elasticity).surfaceSpeed(mass));
    }

    /** A moves by (1, 2) m/s at 3 rad/s and B by (4, 5) at 6; friction √(¼·1), elasticity max. */
    private static FilledStorage met(FilledStorage storage) {
        storage.add(disc(2, 0.25, 0.125).velocity(1, 2).spin(3));
        storage.add(disc(4, 1, 0.5).velocity(4, 5).spin(6));
        storage.pair(0, 1);
        storage.pairs.normalX[0] = 0.6;
        storage.pairs.normalY[0] = 0.8;
        return storage;
    }

    @Test
    void loadsAPairAsItMoves() {
        FilledStorage storage =
                met(
                        new FilledStorage(
                                new Contacts(),
                                new Rotation(),
                                new Friction(),
                                new Restitution(),
                                new SurfaceSpeed()));
        Impact impact = new Impact();
        impact.points = 2;
        impact.load(storage.bodies, storage.pairs, 0);

        assertThat(impact.points).isZero();
        assertThat(new double[] {impact.normalX, impact.normalY}).containsExactly(0.6, 0.8);
        assertThat(new double[] {impact.friction, impact.elasticity}).containsExactly(0.5, 0.5);
        assertThat(impact.surfaceSpeed).isEqualTo(6);
        assertThat(new double[] {impact.inverseMassA, impact.inverseInertiaA})
                .containsExactly(0.5, 1);
        assertThat(new double[] {impact.inverseMassB, impact.inverseInertiaB})
                .containsExactly(0.25, 0.5);
        assertThat(new double[] {impact.velocityAX, impact.velocityAY, impact.spinA})
                .containsExactly(1, 2, 3);
        assertThat(new double[] {impact.velocityBX, impact.velocityBY, impact.spinB})
                .containsExactly(4, 5, 6);
    }

    @Test
    void whatIsNotDeclaredIsZero() {
        FilledStorage storage = met(new FilledStorage(new Contacts()));
        Impact impact = new Impact();
        impact.load(storage.bodies, storage.pairs, 0);

        assertThat(impact.friction).isZero();
        assertThat(impact.elasticity).isZero();
        assertThat(impact.surfaceSpeed).isZero();
        assertThat(impact.inverseInertiaA).isZero();
        assertThat(impact.inverseInertiaB).isZero();
        assertThat(impact.spinA).isZero();
        assertThat(impact.spinB).isZero();
    }

    @Test
    void storesTheVelocitiesAfterIt() {
        FilledStorage storage = met(new FilledStorage(new Contacts(), new Rotation()));
        impactWithVelocities().store(storage.bodies, storage.pairs, 0);

        assertThat(storage.bodies.velocityX).startsWith(-1, -4);
        assertThat(storage.bodies.velocityY).startsWith(-2, -5);
        assertThat(storage.bodies.spin).startsWith(-3, -6);
    }

    @Test
    void storesNoSpinWhereNothingTurns() {
        FilledStorage storage = met(new FilledStorage(new Contacts()));
        impactWithVelocities().store(storage.bodies, storage.pairs, 0);

        assertThat(storage.bodies.velocityX).startsWith(-1, -4);
        assertThat(storage.bodies.spin).isNull();
    }

    /** Not even what an impulse beyond all bounds makes of them, 0·∞. */
    @Test
    void storesNothingOfWhatCannotBeMoved() {
        FilledStorage storage = new FilledStorage(new Contacts(), new Rotation());
        storage.add(BodyDefinition.kinematic(new Circle(1)).velocity(1, 2).spin(3));
        storage.add(BodyDefinition.fixed(new Circle(1)));
        storage.pair(0, 1);
        impactWithVelocities().store(storage.bodies, storage.pairs, 0);

        assertThat(storage.bodies.velocityX).startsWith(1, 0);
        assertThat(storage.bodies.velocityY).startsWith(2, 0);
        assertThat(storage.bodies.spin).startsWith(3, 0);
    }

    private static Impact impactWithVelocities() {
        Impact impact = new Impact();
        impact.velocityAX = -1;
        impact.velocityAY = -2;
        impact.spinA = -3;
        impact.velocityBX = -4;
        impact.velocityBY = -5;
        impact.spinB = -6;
        return impact;
    }

    @Test
    void pointsAreSeenFromBothCentres() {
        Impact impact = new Impact();
        impact.addPoint(5, 7, 1, 2, 3, 4);
        impact.addPoint(6, 9, 1, 2, 3, 4);

        assertThat(impact.points).isEqualTo(2);
        assertThat(impact.armAX).containsExactly(4, 5);
        assertThat(impact.armAY).containsExactly(5, 7);
        assertThat(impact.armBX).containsExactly(2, 3);
        assertThat(impact.armBY).containsExactly(3, 5);
    }
}
