package rigibo.peers;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.World;

import java.util.stream.Stream;

/** Bodies meet in other engines as we say it, within those engines' tolerances. */
class PeerContactTest {

    /** Floats have seven digits, and some are lost on the way. */
    private static final double FLOATS = 1e-4;

    /** How far polygons overlap or stay apart at rest by their engines' choice, m. */
    private static final double SLOP = 0.02;

    private static final double GRAVITY = 9.81;
    private static final Polygon BOX = Polygon.box(1, 1);
    private static final BodyDefinition FLOOR = BodyDefinition.fixed(Polygon.box(100, 2)).at(0, -1);
    private static final BodyDefinition WALL = BodyDefinition.fixed(Polygon.box(0.2, 10)).at(5, 0);
    private static final BodyDefinition BALL = BodyDefinition.dynamic(new Circle(0.1));

    private static final Effects RESTING =
            Effects.of(new Gravity(0, -GRAVITY), new Contacts(), new Rotation(), new Friction());
    private static final Effects BOUNCING = Effects.of(new Contacts(), new Restitution());

    private static Stream<Peer> peers() {
        return Peer.all();
    }

    @ParameterizedTest
    @MethodSource("peers")
    void boxRestsOnAFloorThatCarriesItsWeight(Peer peer) {
        try (World world = peer.world(RESTING)) {
            int floor = world.add(FLOOR);
            int box = world.add(BodyDefinition.dynamic(BOX).at(0, 0.6).mass(7));
            peer.run(world, 3);
            world.watchImpulses();
            // Asked twice, told once.
            world.watchImpulses();
            world.step(peer.step());
            assertThat(world.y(box)).isCloseTo(0.5, within(SLOP));
            assertThat(world.velocityY(box)).isCloseTo(0, within(FLOATS));
            double weight = 7 * GRAVITY * peer.step();
            assertThat(world.normalImpulse(floor, box)).isCloseTo(weight, within(1e-3 * weight));
            assertThat(world.normalImpulse(box, floor)).isEqualTo(world.normalImpulse(floor, box));
            assertThat(world.y(floor)).isEqualTo(-1);
        }
    }

    /** Elasticity of two materials is the larger one. */
    @ParameterizedTest
    @MethodSource("peers")
    void elasticBallReturnsFromAWallThatIsNot(Peer peer) {
        try (World world = peer.world(BOUNCING)) {
            int wall = world.add(WALL);
            Material rubber = Material.DEFAULT.elasticity(1);
            int ball = world.add(BALL.at(4, 0).velocity(6, 0).material(rubber).mass(2));
            world.watchImpulses();
            double most = 0;
            for (int i = 0; i < Math.round(1 / peer.step()); i++) {
                world.step(peer.step());
                most = Math.max(most, world.normalImpulse(wall, ball));
            }
            assertThat(world.velocityX(ball)).isCloseTo(-6, within(6 * FLOATS));
            assertThat(most).isCloseTo(2 * 12, within(24 * FLOATS));
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void nothingBouncesWhereRestitutionIsNotDeclared(Peer peer) {
        try (World world = peer.world(Effects.of(new Contacts()))) {
            world.add(WALL);
            Material rubber = Material.DEFAULT.elasticity(1);
            int ball = world.add(BALL.at(4, 0).velocity(6, 0).material(rubber));
            peer.run(world, 1);
            assertThat(world.velocityX(ball)).isCloseTo(0, within(FLOATS));
        }
    }

    /** μ = √(0.2·0.8) = 0.4: sliding, v = v₀ − μ·g·t. */
    @ParameterizedTest
    @MethodSource("peers")
    void frictionIsTheGeometricMean(Peer peer) {
        try (World world = peer.world(RESTING)) {
            world.add(FLOOR.material(Material.DEFAULT.friction(0.2)));
            Material rough = Material.DEFAULT.friction(0.8);
            // 0.01 m of a skin about each polygon, so that it neither falls nor is lifted.
            int box = world.add(BodyDefinition.dynamic(BOX).at(0, 0.51).material(rough));
            peer.run(world, 0.5);
            double before = world.velocityX(box);
            assertThat(before).isCloseTo(0, within(FLOATS));
            int sliding =
                    world.add(
                            BodyDefinition.dynamic(BOX)
                                    .at(10, 0.51)
                                    .velocity(6, 0)
                                    .material(rough));
            peer.run(world, 1);
            double truth = 6 - 0.4 * GRAVITY;
            assertThat(world.velocityX(sliding)).isCloseTo(truth, within(0.02 * truth));
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void nothingBrakesASlideWhereFrictionIsNotDeclared(Peer peer) {
        try (World world = peer.world(RESTING.without(Friction.class))) {
            world.add(FLOOR);
            int box = world.add(BodyDefinition.dynamic(BOX).at(0, 0.51).velocity(6, 0));
            peer.run(world, 1);
            assertThat(world.velocityX(box)).isCloseTo(6, within(FLOATS));
        }
    }

    /** Masses 1 and 3 part with half the speed each, as momentum and energy ask. */
    @ParameterizedTest
    @MethodSource("peers")
    void statedMassesCollide(Peer peer) {
        try (World world = peer.world(BOUNCING)) {
            Material rubber = Material.DEFAULT.elasticity(1);
            int light = world.add(BALL.at(-1, 0).velocity(4, 0).mass(1).material(rubber));
            int heavy = world.add(BALL.mass(3).material(rubber));
            peer.run(world, 1);
            assertThat(world.velocityX(light)).isCloseTo(-2, within(4 * FLOATS));
            assertThat(world.velocityX(heavy)).isCloseTo(2, within(4 * FLOATS));
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void bodiesOfAGroupPassThroughEachOther(Peer peer) {
        try (World world = peer.world(BOUNCING)) {
            world.add(WALL.group(3));
            int friend = world.add(BALL.at(4, 1).velocity(2, 0).group(3));
            int stranger = world.add(BALL.at(4, -1).velocity(2, 0).group(4));
            peer.run(world, 2);
            assertThat(world.x(friend)).isCloseTo(8, within(8 * FLOATS * peer.substeps()));
            assertThat(world.x(stranger)).isLessThan(5);
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void bodiesPassThroughEachOtherWhereContactsAreNotDeclared(Peer peer) {
        try (World world = peer.world(Effects.of(new Rotation()))) {
            world.add(WALL);
            int ball = world.add(BALL.at(4, 1).velocity(2, 0));
            peer.run(world, 2);
            assertThat(world.x(ball)).isCloseTo(8, within(8 * FLOATS * peer.substeps()));
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void bulletIsStoppedByAThinWallOnlyWhereContinuousImpactsAreDeclared(Peer peer) {
        for (Effects effects : new Effects[] {BOUNCING, BOUNCING.with(new ContinuousImpacts())}) {
            try (World world = peer.world(effects)) {
                world.add(BodyDefinition.fixed(Polygon.box(0.02, 10)).at(5.6, 0));
                int bullet = world.add(BALL.velocity(100, 0));
                peer.run(world, 0.5);
                boolean isStopped = world.x(bullet) < 5.6;
                assertThat(isStopped).isEqualTo(effects.declares(ContinuousImpacts.class));
            }
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void kinematicBodyShovesAndIsNotShoved(Peer peer) {
        try (World world = peer.world(BOUNCING)) {
            int plough = world.add(BodyDefinition.kinematic(BOX).velocity(3, 0));
            int ball = world.add(BALL.at(1, 0).mass(1000));
            peer.run(world, 2);
            assertThat(world.x(plough)).isCloseTo(6, within(6 * FLOATS));
            assertThat(world.velocityX(ball)).isCloseTo(3, within(0.01));
        }
    }

    /** Off the centre, so that it would turn if it could. */
    @ParameterizedTest
    @MethodSource("peers")
    void bodiesTurnOnlyWhereRotationIsDeclared(Peer peer) {
        for (Effects effects : new Effects[] {BOUNCING, BOUNCING.with(new Rotation())}) {
            try (World world = peer.world(effects)) {
                world.add(BALL.at(-2, 0.4).velocity(5, 0).mass(10));
                int box = world.add(BodyDefinition.dynamic(BOX).mass(10));
                peer.run(world, 1);
                boolean turns = world.spin(box) != 0;
                assertThat(turns).isEqualTo(effects.declares(Rotation.class));
            }
        }
    }

    /** Half a second at rest is what all of them wait. */
    @ParameterizedTest
    @MethodSource("peers")
    void boxAsleepIsExactlyStill(Peer peer) {
        try (World world = peer.world(RESTING.with(new Sleep()))) {
            world.add(FLOOR);
            int box = world.add(BodyDefinition.dynamic(BOX).at(0, 0.55));
            peer.run(world, 3);
            assertThat(world.velocityY(box)).isZero();
            double y = world.y(box);
            peer.run(world, 1);
            assertThat(world.y(box)).isEqualTo(y);
        }
    }

    /** Two squares make a plank, which lies flat at half its height; a capsule lies on its side. */
    @ParameterizedTest
    @MethodSource("peers")
    void compoundsAndCapsulesRestOnAChain(Peer peer) {
        Compound plank = Compound.of(Part.of(BOX).at(3, 0), Part.of(BOX).at(4, 0));
        Capsule capsule = new Capsule(0.5, 0.25);
        try (World world = peer.world(RESTING)) {
            world.add(BodyDefinition.fixed(Chain.open(20, 0, 4, 0, -3, 0, -20, 0)));
            int onFace = world.add(BodyDefinition.dynamic(plank).at(0, 0.6));
            int onSide = world.add(BodyDefinition.dynamic(capsule).at(5, 0.35));
            peer.run(world, 3);
            assertThat(world.x(onFace)).isCloseTo(0, within(SLOP));
            assertThat(world.y(onFace)).isCloseTo(0.5, within(SLOP));
            assertThat(world.x(onSide)).isCloseTo(5, within(SLOP));
            assertThat(world.y(onSide)).isCloseTo(0.25, within(SLOP));
        }
    }
}
