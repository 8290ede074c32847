package rigibo.backend.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;

/** Archimedes, and the drag of water. Bodies weigh 1 kg and 1 kg·m². */
class BuoyantForceTest {

    /** Some units in the last place of the forces, which are tens of newtons at most. */
    private static final double ROUND_OFF = 1e-13;

    private static final double G = 10;
    private static final double DENSITY = 3;
    private static final Gravity DOWN = new Gravity(0, -G);

    private static Instant afloat(Instant at, double drag) {
        new BuoyantForce(new Buoyancy(0, DENSITY, drag), DOWN).add(at);
        return at;
    }

    private static void require(Instant at, double forceX, double forceY, double torque) {
        assertThat(at.accelerationX).as("force x").isEqualTo(forceX, within(ROUND_OFF));
        assertThat(at.accelerationY).as("force y").isEqualTo(forceY, within(ROUND_OFF));
        assertThat(at.angularAcceleration).as("torque").isEqualTo(torque, within(ROUND_OFF));
    }

    /** Half of 1 × 2 m displaces 1 m². */
    @Test
    void halfABoxIsLiftedByHalfItsWater() {
        require(afloat(Instants.of(Polygon.box(1, 2), 0), 0), 0, DENSITY * G, 0);
    }

    /** The level is the water's, not the body's. */
    @Test
    void theLevelIsWhereItWasDeclared() {
        Instant at = Instants.of(Polygon.box(1, 2), 0);
        at.x = 5;
        at.y = 7.75;
        new BuoyantForce(new Buoyancy(7, DENSITY, 0), DOWN).add(at);
        require(at, 0, 0.25 * DENSITY * G, 0);
    }

    @Test
    void liftIsAgainstGravityWhereverThatPoints() {
        Instant at = Instants.of(new Circle(1), 0);
        new BuoyantForce(new Buoyancy(5, DENSITY, 0), new Gravity(4, -3)).add(at);
        double displaced = DENSITY * Math.PI;
        require(at, -4 * displaced, 3 * displaced, 0);
    }

    @Test
    void accelerationIsForceByMassAndTorqueByInertia() {
        Instant light = afloat(Instants.of(Polygon.box(2, 1), 0.3), 0);
        Instant heavy = afloat(Instants.of(Polygon.box(2, 1), 4, 8, 0.3), 0);
        assertThat(heavy.accelerationY).isEqualTo(light.accelerationY / 4, within(ROUND_OFF));
        assertThat(heavy.angularAcceleration)
                .isEqualTo(light.angularAcceleration / 8, within(ROUND_OFF));
    }

    /**
     * A box of the breadth b and the height 2d, turned by θ about its centre in the water line:
     * seen from the box the centroid moves by b²·tan θ/(12·d) to the sunken side and by b²·tan²
     * θ/(24·d) up from d/2 under the centre (Attwood and Pengelly, "Theoretical Naval
     * Architecture", the wall-sided ship).
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, -0.1, 0.4})
    void aTiltedBoxIsRightedAsAWallSidedShip(double angle) {
        double b = 2;
        double d = 0.5;
        double tan = Math.tan(angle);
        double x = -b * b * tan / (12 * d);
        double y = -d / 2 + b * b * tan * tan / (24 * d);
        double lever = Math.cos(angle) * x - Math.sin(angle) * y;
        double lift = DENSITY * b * d * G;

        require(afloat(Instants.of(Polygon.box(b, 2 * d), angle), 0), 0, lift, lever * lift);
    }

    /** −d·ρ·A·v, at the centroid of the half disc, 4/3π under the centre. */
    @Test
    void waterBrakesWhatMoves() {
        Instant at = Instants.of(new Circle(1), 0);
        at.velocityX = 2;
        at.velocityY = -1;
        double braking = 0.5 * DENSITY * Math.PI / 2;
        double lift = DENSITY * G * Math.PI / 2;
        double depth = 4 / (3 * Math.PI);
        require(afloat(at, 0.5), -2 * braking, lift + braking, -2 * braking * depth);
    }

    /** The torque −d·ρ·ω·∫r²dA, πr⁴/4 for the half disc, and −d·ρ·A·(ω × c) of the centroid. */
    @Test
    void waterBrakesWhatTurns() {
        Instant at = Instants.of(new Circle(1), 0);
        at.spin = 2;
        double depth = 4 / (3 * Math.PI);
        double force = -0.5 * DENSITY * (Math.PI / 2) * (2 * depth);
        double torque = -0.5 * DENSITY * 2 * Math.PI / 4;
        require(afloat(at, 0.5), force, DENSITY * G * Math.PI / 2, torque);
    }

    /**
     * Point by point −d·ρ·(v + ω × r): in all −d·ρ·(A·v + ω × ∫r dA), and about the centre of mass
     * −d·ρ·(∫r dA × v + ω·∫r² dA).
     */
    @Test
    void aTiltedBoxThatMovesAndTurns() {
        Polygon box = Polygon.box(2, 1);
        Instant at = Instants.of(box, 0.7);
        at.velocityX = 1.5;
        at.velocityY = -0.5;
        at.spin = -3;
        at.y = 0.2;
        Strips water = Strips.of(box, 0.7, -0.2);
        double brake = 0.25 * DENSITY;
        double lift = DENSITY * G * water.area;
        double forceX = -brake * (1.5 * water.area + 3 * water.momentY);
        double forceY = -brake * (-0.5 * water.area - 3 * water.momentX);
        double drag = water.momentX * -0.5 - water.momentY * 1.5 - 3 * water.second;
        double torque = DENSITY * G * water.momentX - brake * drag;
        require(afloat(at, 0.25), forceX, lift + forceY, torque);
    }

    @Test
    void overTheWaterNothingActs() {
        Instant at = Instants.of(Polygon.box(2, 1), 0.3);
        at.y = 3;
        at.velocityX = 5;
        at.spin = 7;
        at.accelerationX = 1;
        require(afloat(at, 2), 1, 0, 0);
    }
}
