package rigibo.peers;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.World;

import java.util.stream.Stream;

/** Bodies that touch nothing move in other engines as those engines' own errors let them. */
class PeerMotionTest {

    /** Floats have seven digits, and some are lost on the way. */
    private static final double FLOATS = 1e-4;

    private static final double GRAVITY = 9.81;
    private static final Polygon BOX = Polygon.box(2, 1);

    private static Stream<Peer> peers() {
        return Peer.all();
    }

    /** Velocity first, then place: n substeps of h fall by g·h²·n(n + 1)/2. */
    @ParameterizedTest
    @MethodSource("peers")
    void fallsBySymplecticEuler(Peer peer) {
        try (World world = peer.world(Effects.of(new Gravity(0, -GRAVITY)))) {
            int body = world.add(BodyDefinition.dynamic(BOX).at(3, 100).velocity(2, 0));
            int floats = world.add(BodyDefinition.dynamic(BOX).gravityScale(0));
            int n = peer.run(world, 4) * peer.substeps();
            double h = peer.step() / peer.substeps();
            double fall = GRAVITY * h * h * n * (n + 1) / 2;
            double rounding = FLOATS * peer.substeps();
            assertThat(world.y(body)).isCloseTo(100 - fall, within(rounding * fall));
            assertThat(world.x(body)).isCloseTo(3 + 2 * 4, within(rounding * 8));
            assertThat(world.velocityX(body)).isEqualTo(2);
            assertThat(world.velocityY(body)).isCloseTo(-GRAVITY * 4, within(rounding * 40));
            assertThat(world.y(floats)).isZero();
        }
    }

    /**
     * Symplectic Euler shifts a spring's phase and amplitude by ω·dt at most, and loses nothing. A
     * step of n substeps under the force of its beginning goes by v·dt + a·dt²(1 + 1/n)/2: the
     * determinant of such a step is 1 + (ω·dt)²(1 − 1/n)/2, its root what the amplitude grows by.
     */
    @ParameterizedTest
    @MethodSource("peers")
    void swingsOnASpring(Peer peer) {
        double omega = 2 * Math.PI;
        Field spring = new Field(at -> at.push(-omega * omega * at.mass * at.x, 0));
        try (World world = peer.world(Effects.of(spring))) {
            int body = world.add(BodyDefinition.dynamic(BOX).at(1, 0).mass(3));
            double turn = omega * peer.step();
            double growth = Math.sqrt(1 + turn * turn * (1 - 1.0 / peer.substeps()) / 2);
            double after = Math.pow(growth, peer.run(world, 0.5));
            assertThat(world.x(body)).isCloseTo(-after, within(turn * after));
            after *= Math.pow(growth, peer.run(world, 9.5));
            assertThat(world.x(body)).isCloseTo(after, within(turn * after));
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void centralForceOfPowerOneIsASpring(Peer peer) {
        Field spring = new Field(at -> at.accelerate(-4 * (at.x - 1), -4 * (at.y - 2)));
        CentralForce centre = new CentralForce(1, 2, 4, 1);
        try (World pulled = peer.world(Effects.of(centre));
                World sprung = peer.world(Effects.of(spring))) {
            BodyDefinition body = BodyDefinition.dynamic(BOX).at(4, 3).velocity(0, 1);
            pulled.add(body);
            sprung.add(body);
            peer.run(pulled, 3);
            peer.run(sprung, 3);
            assertThat(pulled.x(0)).isCloseTo(sprung.x(0), within(FLOATS * 4));
            assertThat(pulled.y(0)).isCloseTo(sprung.y(0), within(FLOATS * 4));
        }
    }

    /**
     * v = v₀·e^(−kt) by steps that are right to first order: off by about k·dt/2 of the exponent.
     */
    @ParameterizedTest
    @MethodSource("peers")
    void dragBrakes(Peer peer) {
        try (World world = peer.world(Effects.of(new Drag()))) {
            Material oil = Material.DEFAULT.drag(0.5);
            int body = world.add(BodyDefinition.dynamic(BOX).velocity(8, 0).material(oil));
            peer.run(world, 2);
            double truth = 8 * Math.exp(-1);
            assertThat(world.velocityX(body)).isCloseTo(truth, within(truth * 0.5 * peer.step()));
        }
    }

    /**
     * v' = −K·v² with K = ½·ρ·c·A/m goes as v₀/(1 + K·v₀·t). Moving up, a box lying on its side is
     * 2 m wide. Steps of first order are off by K·v₀·dt at most.
     */
    @ParameterizedTest
    @MethodSource("peers")
    void airBrakesByTheWidthAcross(Peer peer) {
        try (World world = peer.world(Effects.of(new AirDrag(1, 1)))) {
            int lying = world.add(BodyDefinition.dynamic(BOX).mass(2).velocity(0, 4));
            int upright =
                    world.add(
                            BodyDefinition.dynamic(BOX).mass(2).velocity(0, 4).angle(Math.PI / 2));
            int disc = world.add(BodyDefinition.dynamic(new Circle(0.5)).mass(2).velocity(4, 0));
            peer.run(world, 1);
            double tolerance = 2 * 4 * peer.step();
            assertThat(world.velocityY(lying)).isCloseTo(4 / (1 + 0.5 * 4), within(tolerance));
            assertThat(world.velocityY(upright)).isCloseTo(4 / (1 + 0.25 * 4), within(tolerance));
            assertThat(world.velocityX(disc)).isCloseTo(4 / (1 + 0.25 * 4), within(tolerance));
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void pushLastsOneStep(Peer peer) {
        try (World world = peer.world(Effects.of(new Thrust()))) {
            int body = world.add(BodyDefinition.dynamic(BOX).mass(4));
            world.push(body, 8, -12);
            peer.run(world, 1);
            double dt = peer.step();
            assertThat(world.velocityX(body)).isCloseTo(2 * dt, within(FLOATS * dt));
            assertThat(world.velocityY(body)).isCloseTo(-3 * dt, within(FLOATS * dt));
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void turnsUnbraked(Peer peer) {
        try (World world = peer.world(Effects.of(new Rotation()))) {
            int body = world.add(BodyDefinition.dynamic(BOX).angle(0.25).spin(1.5));
            peer.run(world, 1);
            assertThat(world.spin(body)).isCloseTo(1.5, within(FLOATS));
            assertThat(world.angle(body)).isCloseTo(1.75, within(FLOATS));
        }
    }
}
