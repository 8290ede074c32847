package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

/** Flight in pools without contacts, and free flight, compared with textbook formulas. */
class OpenFlightTest {

    private static final double ROUND_OFF = 1e-14;

    private static void pull(Bodies bodies, int slot) {
        bodies.accelerationX[slot] = 0.5;
        bodies.accelerationY[slot] = -8;
        if (bodies.turns()) {
            bodies.angularAcceleration[slot] = 6;
        }
    }

    private static BodyDefinition thrown(BodyDefinition body) {
        return body.at(1, 2).velocity(3, 4);
    }

    /** Adds a dynamic, a driven and a fixed disc, all under an acceleration. */
    private static FilledStorage three(FilledStorage storage) {
        storage.add(thrown(BodyDefinition.dynamic(new Circle(1))).spin(5));
        storage.add(thrown(BodyDefinition.kinematic(new Circle(1))).spin(5));
        storage.add(BodyDefinition.fixed(new Circle(1)).at(1, 2));
        for (int slot = 0; slot < 3; slot++) {
            pull(storage.bodies, slot);
        }
        return storage;
    }

    private static void assertParabola(Bodies bodies) {
        assertThat(bodies.x).startsWith(2.5625, 1, 1);
        assertThat(bodies.y).startsWith(3, 2, 2);
        assertThat(bodies.velocityX).startsWith(3.25, 3, 0);
        assertThat(bodies.velocityY).startsWith(0, 4, 0);
    }

    /**
     * θ = ωt + ½αt² for each term by itself, at steps of a second and less, in both kinds of
     * flight.
     */
    @ParameterizedTest
    @CsvSource({"1, 0, 0.5", "0, 1, 0.5", "2, 0, 1", "1, 1, 1", "0, 0, 1"})
    void turnsBySpinOrByWhatTurnsIt(double spin, double angular, double dt) {
        for (boolean isOpen : new boolean[] {true, false}) {
            FilledStorage storage = new FilledStorage(new Rotation(), new Contacts());
            storage.add(thrown(BodyDefinition.dynamic(new Circle(1))).spin(spin));
            storage.bodies.angularAcceleration[0] = angular;
            if (isOpen) {
                new OpenFlight(storage.data, null).fly(dt);
            } else {
                new FreeFlight(storage.data, null).fly(dt);
            }
            double angle = spin * dt + angular * dt * dt / 2;
            assertThat(storage.bodies.angle[0]).isEqualTo(angle, within(ROUND_OFF));
            assertThat(storage.bodies.cos[0]).isEqualTo(Math.cos(angle), within(ROUND_OFF));
            assertThat(storage.bodies.spin[0]).isEqualTo(spin + angular * dt, within(ROUND_OFF));
        }
    }

    @Test
    void onlyDynamicBodiesGoTheirParabola() {
        FilledStorage storage = three(new FilledStorage());
        new OpenFlight(storage.data, null).fly(0.5);

        assertParabola(storage.bodies);
    }

    @Test
    void onlyDynamicBodiesTurn() {
        FilledStorage storage = three(new FilledStorage(new Rotation()));
        new OpenFlight(storage.data, null).fly(0.5);

        assertParabola(storage.bodies);
        assertThat(storage.bodies.angle).startsWith(3.25, 0, 0);
        assertThat(storage.bodies.spin).startsWith(8, 5, 0);
    }

    @Test
    void turnsFromRestAndWithoutATorque() {
        FilledStorage storage = three(new FilledStorage(new Rotation()));
        OpenFlight flight = new OpenFlight(storage.data, null);
        storage.bodies.spin[0] = 0;
        flight.fly(0.5);
        assertThat(storage.bodies.angle[0]).isEqualTo(0.75);
        assertThat(storage.bodies.spin[0]).isEqualTo(3);

        storage.bodies.angularAcceleration[0] = 0;
        flight.fly(0.5);
        assertThat(storage.bodies.angle[0]).isEqualTo(2.25);
        assertThat(storage.bodies.spin[0]).isEqualTo(3);
    }

    /** x = x₀ + v·E₁ + a·E₂ with E₁ = (1 − e^(−kτ))/k and E₂ = (τ − E₁)/k. */
    @Test
    void dragSlowsDynamicBodiesOnly() {
        FilledStorage storage = new FilledStorage(new Drag());
        Material dragged = Material.DEFAULT.drag(2);
        storage.add(thrown(BodyDefinition.dynamic(new Circle(1))).material(dragged));
        storage.add(thrown(BodyDefinition.kinematic(new Circle(1))).material(dragged));
        pull(storage.bodies, 0);
        pull(storage.bodies, 1);
        new OpenFlight(storage.data, null).fly(0.5);

        double e1 = (1 - Math.exp(-1)) / 2;
        double e2 = (0.5 - e1) / 2;
        Bodies bodies = storage.bodies;
        assertThat(bodies.x[0]).isEqualTo(1 + 3 * e1 + 0.5 * e2, within(ROUND_OFF));
        assertThat(bodies.y[0]).isEqualTo(2 + 4 * e1 - 8 * e2, within(ROUND_OFF));
        assertThat(bodies.velocityX[0]).isEqualTo(0.25 + 2.75 * Math.exp(-1), within(ROUND_OFF));
        assertThat(bodies.velocityY[0]).isEqualTo(-4 + 8 * Math.exp(-1), within(ROUND_OFF));
        assertThat(bodies.x[1]).isEqualTo(1);
    }

    /** Free flight leaves bodies of piles to their solver. */
    @Test
    void freeFlightMovesFlyersOnly() {
        FilledStorage storage = three(new FilledStorage(new Contacts(), new Rotation()));
        storage.add(thrown(BodyDefinition.dynamic(new Circle(1))).spin(5));
        storage.bodies.piled[3] = true;
        FreeFlight flight = new FreeFlight(storage.data, null);
        flight.fly(0.5);

        assertParabola(storage.bodies);
        assertThat(storage.bodies.angle).startsWith(3.25, 0, 0, 0);
        assertThat(storage.bodies.x[3]).isEqualTo(1);

        flight.fly(0.5);
        assertThat(storage.bodies.x[0]).as("a step of its own").isEqualTo(4.25, within(ROUND_OFF));
    }
}
