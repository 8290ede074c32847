package rigibo.backend.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.storage.Bodies;

/** The properties that an instant takes over from a body, and its forces. */
class InstantTest {

    private static Instant taken(Bodies bodies) {
        bodies.take();
        int slot = bodies.take();
        bodies.shape[slot] = new Circle(3);
        bodies.mass[slot] = 4;
        bodies.inverseMass[slot] = 0.25;
        bodies.boundingRadius[slot] = 3;
        if (bodies.turns()) {
            bodies.inverseInertia[slot] = 0.5;
        }
        if (bodies.drag != null) {
            bodies.drag[slot] = 6;
        }
        Instant at = new Instant();
        at.drag = 100;
        at.inverseInertia = 100;
        at.take(bodies, slot);
        return at;
    }

    @Test
    void takesOverWhatTheBodyIs() {
        Instant at = taken(new Bodies(Effects.of(new Rotation(), new Drag())));
        assertThat(at.shape).isEqualTo(new Circle(3));
        assertThat(at.mass).isEqualTo(4);
        assertThat(at.inverseMass).isEqualTo(0.25);
        assertThat(at.inverseInertia).isEqualTo(0.5);
        assertThat(at.boundingRadius).isEqualTo(3);
        assertThat(at.drag).isEqualTo(6);
    }

    @Test
    void whatIsNotDeclaredIsNone() {
        Instant at = taken(new Bodies(Effects.of()));
        assertThat(at.inverseInertia).isZero();
        assertThat(at.drag).isZero();
    }

    @Test
    void forcesAndTorquesAddUp() {
        Instant at = Instants.of(new Circle(1), 4, 2, 0);
        at.push(8, -12);
        at.push(4, 4);
        at.turn(6);
        at.turn(-1);
        assertThat(at.accelerationX).isEqualTo(3);
        assertThat(at.accelerationY).isEqualTo(-2);
        assertThat(at.angularAcceleration).isEqualTo(2.5);
    }

    /** Cosine and sine are kept from one call to the next, and never beyond their angle. */
    @Test
    void cosineAndSineAreOfTheAngleAsItIs() {
        Instant at = new Instant();
        for (double angle : new double[] {0, 0.5, 0.5, -2, 0, 3}) {
            at.angle = angle;
            assertThat(at.cos()).isEqualTo(Math.cos(angle), within(1e-15));
            assertThat(at.sin()).isEqualTo(Math.sin(angle), within(1e-15));
            at.angle = angle + 1;
            assertThat(at.sin()).isEqualTo(Math.sin(angle + 1), within(1e-15));
        }
    }
}
