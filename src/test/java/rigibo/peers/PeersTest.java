package rigibo.peers;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** The other engines, and the scenes that they do not run. */
class PeersTest {

    private static final Effects GROUND =
            Effects.of(
                    new Gravity(0, -9.81),
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Drag());

    /** Engines whose polygons have as many corners as anyone likes. */
    private static final Set<String> UNBOUNDED = Set.of("dyn4j", "Rapier");

    private static Stream<Engine> engines() {
        return Peer.engines();
    }

    @Test
    void threeAreAtHandBesidesOurs() {
        assertThat(Engines.all())
                .extracting(Engine::name)
                .contains("RigiBo", "JBox2D 2.2.1.1", "dyn4j 6.0.0", "gdx-box2d 1.14.0");
    }

    /** They are built by a command of their own, which needs Rust. */
    @Test
    void box2dV3AndRapierAreAtHandOrSaidToBeLeftOut() {
        List<String> names = Engines.all().stream().map(Engine::name).toList();
        if (Engines.missing().isEmpty()) {
            assertThat(names).contains("Box2D 3.2.0", "Rapier 0.36.1").hasSize(6);
        } else {
            assertThat(Engines.missing()).singleElement().asString().contains("./rigibo peers");
            assertThat(names).hasSize(4);
        }
    }

    @ParameterizedTest
    @MethodSource("engines")
    void runsAsItComesAndFiner(Engine engine) {
        assertThat(engine.settings())
                .allMatch(setting -> setting.line() == Line.PEERS)
                .extracting(setting -> setting.name())
                .startsWith("default")
                .hasSizeGreaterThan(1)
                .doesNotHaveDuplicates();
    }

    @ParameterizedTest
    @MethodSource("engines")
    void refusesByNameWhatItHasNot(Engine engine) {
        Effect[] missing = {
            new Wind(1, 0), new Buoyancy(0, 1000, 1), new SurfaceSpeed(), new RollingResistance()
        };
        for (Effect effect : missing) {
            assertThatThrownBy(() -> engine.world(GROUND.with(effect), engine.settings().get(0)))
                    .isInstanceOf(UnsupportedOperationException.class)
                    .hasMessage(effect.getClass().getSimpleName());
        }
    }

    @ParameterizedTest
    @MethodSource("engines")
    void impulsesThatNobodyWatchedAreNotTakenForNone(Engine engine) {
        try (World world = engine.world(GROUND.without(Drag.class), engine.settings().get(0))) {
            assertThatThrownBy(() -> world.normalImpulse(0, 1))
                    .isInstanceOf(IllegalStateException.class);
            world.watchImpulses();
            assertThat(world.normalImpulse(0, 1)).isZero();
        }
    }

    /** Box2D stops at eight corners, dyn4j and Rapier do not. */
    @ParameterizedTest
    @MethodSource("engines")
    void nineCornersAreRefusedWithAReasonOrRestOnOne(Engine engine) {
        try (World world = engine.world(GROUND, engine.settings().get(0))) {
            BodyDefinition nine = BodyDefinition.dynamic(Polygon.regular(9, 1));
            if (UNBOUNDED.contains(engine.name().split(" ")[0])) {
                assertThat(world.add(nine)).isZero();
            } else {
                assertThatThrownBy(() -> world.add(nine))
                        .isInstanceOf(UnsupportedOperationException.class)
                        .hasMessage("polygons of more than 8 corners");
            }
        }
    }
}
