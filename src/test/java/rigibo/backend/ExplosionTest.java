package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;

/** A blast hands out so much momentum for each metre of width, away from its centre. */
class ExplosionTest {

    private static final double ROUND_OFF = 1e-12;

    private final Pool pool = new Pool();

    private RigidBody disc(double x, double y) {
        return pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(x, y));
    }

    @Test
    void aDiscIsStruckByItsDiameterAlongTheLineOfCentres() {
        RigidBody near = disc(1.5, 2);
        RigidBody behind = disc(-3, 0);
        RigidBody far = disc(0, -4.7);
        pool.explode(Explosion.at(0, 0).radius(2.1).falloff(2).impulsePerMetre(6));

        // 2.5 m away, so that its rim is within the radius: 6 N·s/m × 1 m.
        assertThat(near.velocityX() * near.mass()).isEqualTo(6 * 0.6, within(ROUND_OFF));
        assertThat(near.velocityY() * near.mass()).isEqualTo(6 * 0.8, within(ROUND_OFF));
        assertThat(near.angularVelocity()).isEqualTo(0, within(ROUND_OFF));
        // 0.4 m of the 2 m in which it falls to nothing.
        assertThat(behind.velocityX() * behind.mass()).isEqualTo(-6 * 0.8, within(ROUND_OFF));
        assertThat(far.velocityY()).as("beyond it").isZero();
    }

    /** Struck at its nearest point: that is where the lever is. */
    @Test
    void aPlankTurns() {
        RigidBody plank = pool.add(BodyDefinition.dynamic(Polygon.box(4, 0.2)).at(1, 1.1));
        pool.explode(Explosion.at(0, 0).radius(3).impulsePerMetre(2));

        assertThat(plank.velocityX()).isEqualTo(0, within(ROUND_OFF));
        assertThat(plank.velocityY() * plank.mass()).isEqualTo(8, within(ROUND_OFF));
        assertThat(plank.angularVelocity() * plank.inertia()).isEqualTo(-8, within(ROUND_OFF));
    }

    @Test
    void whoHoldsItIsStruckThroughItsCentre() {
        RigidBody holding = disc(0.3, 0);
        RigidBody about = disc(5, 5);
        pool.explode(Explosion.at(0, 0).impulsePerMetre(-3));
        pool.explode(Explosion.at(5, 5));

        assertThat(holding.velocityX() * holding.mass()).isEqualTo(-3, within(ROUND_OFF));
        assertThat(about.velocityX()).isZero();
    }

    @Test
    void onlyWhoIsMeantIsStruckAndWakes() {
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(0, -0.5));
        RigidBody spared = disc(-1, 0.5);
        RigidBody struck =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.5))
                                .at(1, 0.5)
                                .filter(Filter.ALL.category(4)));
        for (int i = 0; i < 120; i++) {
            pool.step(1 / 60.0);
        }
        assertThat(struck.isAwake()).isFalse();
        pool.explode(Explosion.at(0, 0.5).radius(3).filter(Filter.ALL.mask(4)));

        assertThat(struck.isAwake()).isTrue();
        assertThat(struck.velocityX()).isPositive();
        assertThat(spared.velocityX()).isZero();
        assertThat(floor.velocityX()).isZero();
    }

    /** The second of them is so light that it would be faster than light. */
    @Test
    void aBlastThatIsTooStrongForOneStrikesNobody() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(1, 0).awake(false));
        pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(-1, 0).mass(1e-12).awake(false));
        long before = pool.stateHash();
        assertThatThrownBy(() -> pool.explode(Explosion.at(0, 0).radius(5)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("velocity");
        assertThat(pool.stateHash()).isEqualTo(before);
    }

    @Test
    void numbersThatAreNoneAreRefused() {
        assertThatThrownBy(() -> Explosion.at(Double.NaN, 0)).hasMessageContaining("Explosion.x");
        assertThatThrownBy(() -> Explosion.at(0, 0).radius(-1)).hasMessageContaining("radius");
        assertThatThrownBy(() -> Explosion.at(0, 0).falloff(-1)).hasMessageContaining("falloff");
        assertThatThrownBy(() -> pool.explode(null)).hasMessageContaining("Pool.explode");
    }
}
