package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.List;
import java.util.stream.Stream;

/** Bad input is refused, and the messages say why. */
class DoorTest {

    private static final BodyDefinition BOX = BodyDefinition.dynamic(Polygon.box(1, 1));
    private static final double NAN = Double.NaN;

    private static Arguments refusal(ThrowingCallable attempt, String... words) {
        return Arguments.of(attempt, words);
    }

    /** Each with the field, the value, the unit and the range that its message must name. */
    static Stream<Arguments> refusals() {
        Pool pool = new Pool();
        RigidBody body = pool.add(BOX);
        return Stream.of(
                refusal(() -> new Circle(-2), "Circle.radius", "-2.0", "(m)", "positive"),
                refusal(() -> Polygon.box(0, 1), "Polygon.box width", "0.0", "(m)", "positive"),
                refusal(() -> Polygon.regular(257, 1), "corners", "257", "3 to 256"),
                refusal(() -> new Material(-1, 0, 0), "Material.density", "-1.0", "(kg/m²)"),
                refusal(() -> new Material(1, -2, 0), "Material.friction", "-2.0", "0.0 to 1.0E9"),
                refusal(() -> new Material(1, 0, 1.5), "Material.elasticity", "1.5", "0.0 to 1.0"),
                refusal(() -> BOX.at(NAN, 0), "BodyDefinition.x", "NaN", "(m)", "finite"),
                refusal(() -> BOX.velocity(0, NAN), "velocityY", "NaN", "(m/s)", "-2.9", " to "),
                refusal(() -> BOX.spin(1e9), "spin", "1.0E9", "(rad/s)", "-1000000.0 to 1000000.0"),
                refusal(() -> BOX.mass(0), "BodyDefinition.mass", "0.0", "(kg)", "positive"),
                refusal(() -> BOX.inertia(-1), "inertia", "-1.0", "(kg·m²)", "positive"),
                refusal(() -> new Gravity(NAN, 0), "Gravity.x", "NaN", "(m/s²)", " to "),
                refusal(() -> new AirDrag(-1, 1), "AirDrag.density", "-1.0", "(kg/m³)", "zero"),
                refusal(() -> new AirDrag(1, NAN), "AirDrag.coefficient", "NaN", "zero or more"),
                refusal(() -> new Wind(2e4, 0), "Wind.x", "20000.0", "(m/s)", "-10000.0 to 1"),
                refusal(() -> new Wind(0, 0, null), "Wind.gusts", "null"),
                refusal(() -> new Field(null), "Field.function", "null"),
                refusal(() -> Polygon.of((double[]) null), "Polygon.of xy", "null"),
                refusal(() -> Polygon.hull((double[]) null), "Polygon.hull xy", "null"),
                refusal(() -> Compound.of((Part[]) null), "Compound.of parts", "null"),
                refusal(() -> Compound.of((List<Part>) null), "Compound.of parts", "null"),
                refusal(
                        () -> Compound.of(Part.of(new Circle(1)), null),
                        "Compound.of part 1",
                        "null"),
                refusal(() -> Compound.ofOutline((double[]) null), "ofOutline xy", "null"),
                refusal(() -> Effects.of((Effect[]) null), "Effects.of effects", "null"),
                refusal(() -> Effects.usual().with(null), "Effects.with effect", "null"),
                refusal(() -> Effects.usual().without(null), "Effects.without kind", "null"),
                refusal(
                        () -> new Pool().overlapping(new Aabb(0, 0, 1, 1), null),
                        "Pool.overlapping visitor",
                        "null"),
                refusal(() -> new CentralForce(NAN, 0, 1, 1), "CentralForce.x", "NaN", "(m)"),
                refusal(() -> new CentralForce(0, 0, 1, 9), "power", "9.0", "-8.0 to 8.0"),
                refusal(() -> new Buoyancy(NAN, 1, 0), "Buoyancy.level", "NaN", "(m)", "finite"),
                refusal(() -> new Buoyancy(0, -1, 0), "density", "-1.0", "(kg/m²)", "zero"),
                refusal(() -> new Buoyancy(0, 1, -2), "drag", "-2.0", "(1/s)", "zero or more"),
                refusal(() -> new Sleep(0, 1), "Sleep.seconds", "0.0", "(s)", "positive"),
                refusal(() -> Accuracy.GAME.withSubsteps(65), "substeps", "65", "1 to 64"),
                refusal(
                        () -> Accuracy.GAME.withImpactTolerance(1),
                        "impactTolerance",
                        "1.0",
                        "(m)",
                        "1.0E-9 to 0.001"),
                refusal(() -> pool.step(0), "Pool.step dt", "0.0", "(s)", "1.0E-9 to 10.0"),
                refusal(() -> pool.step(NAN), "Pool.step dt", "NaN", "(s)", "1.0E-9 to 10.0"),
                refusal(() -> body.moveTo(0, NAN, 0), "moveTo", "y", "NaN", "(m)", "finite"),
                refusal(() -> body.velocity(NAN, 0), "velocity", "NaN", "(m/s)", " to "),
                refusal(() -> body.applyImpulse(NAN, 0, 0, 0), "jx", "NaN", "(N·s)", "finite"));
    }

    @ParameterizedTest
    @MethodSource("refusals")
    void refusalNamesFieldValueUnitAndRange(ThrowingCallable attempt, String... words) {
        assertThatIllegalArgumentException().isThrownBy(attempt).withMessageContainingAll(words);
    }

    @Test
    void refusedBodyLeavesThePoolAsItWas() {
        Pool pool = Scenes.STACK.build();
        long before = pool.stateHash();
        assertThatIllegalArgumentException().isThrownBy(() -> pool.add(null));
        assertThatIllegalArgumentException().isThrownBy(() -> pool.step(-1));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> pool.bodies().get(1).moveTo(1, 2, NAN));
        assertThat(pool.stateHash()).isEqualTo(before);
        assertThat(pool.bodies()).hasSize(11);
    }

    static Stream<ThrowingCallable> verbsOfARemovedBody() {
        Pool pool = new Pool();
        RigidBody body = pool.add(BOX.name("gone"));
        pool.remove(body);
        return Stream.of(
                body::x,
                body::velocityY,
                body::mass,
                body::shape,
                body::isAwake,
                () -> body.moveTo(0, 0, 0),
                () -> body.velocity(0, 0),
                () -> body.spin(0),
                () -> body.applyImpulse(0, 0, 0, 0),
                () -> body.applyForce(0, 0, 0, 0),
                () -> body.applyTorque(0),
                () -> body.type(BodyType.STATIC),
                () -> body.material(Material.DEFAULT),
                () -> body.shape(new Circle(1)),
                body::wake,
                () -> pool.remove(body),
                () -> pool.touching(body, body));
    }

    @ParameterizedTest
    @MethodSource("verbsOfARemovedBody")
    void removedBodyAnswersNothing(ThrowingCallable verb) {
        assertThatIllegalStateException().isThrownBy(verb).withMessageContaining("'gone'");
    }

    @Test
    void removedBodyStillTellsItsName() {
        Pool pool = new Pool();
        RigidBody body = pool.add(BOX.name("gone"));
        pool.remove(body);
        assertThat(body.isAlive()).isFalse();
        assertThat(body.name()).isEqualTo("gone");
        assertThat(body.toString()).contains("gone", "removed");
        assertThat(pool.bodies()).isEmpty();
    }

    @Test
    void bodyOfAnotherPoolIsRefused() {
        Pool pool = new Pool();
        RigidBody own = pool.add(BOX);
        RigidBody stranger = new Pool().add(BOX.name("stranger"));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> pool.remove(stranger))
                .withMessageContaining("'stranger'");
        assertThatIllegalArgumentException().isThrownBy(() -> pool.touching(own, stranger));
        assertThat(stranger.isAlive()).isTrue();
    }

    static Stream<Arguments> lonelyEffects() {
        return Stream.of(
                Arguments.of(new Friction(), "Contacts"),
                Arguments.of(new Restitution(), "Contacts"),
                Arguments.of(new ContinuousImpacts(), "Contacts"),
                Arguments.of(new Sleep(), "Contacts"),
                Arguments.of(new RollingResistance(), "Contacts"),
                Arguments.of(new SurfaceSpeed(), "Friction"),
                Arguments.of(new Wind(1, 0), "Drag or AirDrag"),
                Arguments.of(new Buoyancy(0, 1, 0), "Gravity"));
    }

    @ParameterizedTest
    @MethodSource("lonelyEffects")
    void effectWithoutWhatItNeedsIsRefusedNamingBoth(Effect effect, String needed) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Effects.of(effect))
                .withMessageContainingAll(effect.getClass().getSimpleName(), needed);
    }

    @Test
    void effectThatOthersNeedCannotBeTakenAway() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Effects.of(new Contacts(), new Sleep()).without(Contacts.class))
                .withMessageContainingAll("Sleep", "Contacts");
    }

    @Test
    void undeclaredThrustIsNamed() {
        RigidBody body = new Pool().add(BOX);
        assertThatIllegalStateException()
                .isThrownBy(() -> body.applyForce(1, 0, 0, 0))
                .withMessageContaining("Thrust");
        assertThatIllegalStateException()
                .isThrownBy(() -> body.applyTorque(1))
                .withMessageContaining("Thrust");
    }

    @Test
    void listOfBodiesCannotBeChangedFromOutside() {
        Pool pool = new Pool();
        pool.add(BOX);
        assertThatThrownBy(() -> pool.bodies().clear())
                .isInstanceOf(UnsupportedOperationException.class);
    }
}
