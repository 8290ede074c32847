package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Collections;
import java.util.Random;

class CompoundTest {

    /** Sums of a few terms, each rounded a few times. */
    private static final double ROUND_OFF = 1e-14;

    @Test
    void aBoxOfFourBoxesWeighsWhatTheBoxDoes() {
        MassProperties whole = Polygon.box(0.8, 0.4).massProperties(3);
        MassProperties four = quarters(0.8, 0.4).massProperties(3);

        assertThat(four.mass()).isEqualTo(whole.mass(), within(ROUND_OFF));
        assertThat(four.inertia()).isEqualTo(whole.inertia(), within(ROUND_OFF));
        assertThat(quarters(0.8, 0.4).boundingRadius())
                .isEqualTo(Polygon.box(0.8, 0.4).boundingRadius(), within(ROUND_OFF));
        assertThat(quarters(0.8, 0.4).area()).isEqualTo(0.32, within(ROUND_OFF));
    }

    /** Two discs of mass m at ±d: 2·(m·r²/2 + m·d²), the parallel axis. */
    @Test
    void aDumbbellTurnsByTheParallelAxis() {
        Compound dumbbell =
                Compound.of(Part.of(new Circle(0.2)).at(4, 7), Part.of(new Circle(0.2)).at(5, 7));
        double mass = 3 * Math.PI * 0.04;

        assertThat(dumbbell.massProperties(3).mass()).isEqualTo(2 * mass, within(ROUND_OFF));
        assertThat(dumbbell.massProperties(3).inertia())
                .isEqualTo(2 * mass * (0.02 + 0.25), within(ROUND_OFF));
        assertThat(dumbbell.centroidX()).isEqualTo(4.5, within(ROUND_OFF));
        assertThat(dumbbell.centroidY()).isEqualTo(7, within(ROUND_OFF));
        assertThat(dumbbell.boundingRadius()).isEqualTo(0.7, within(ROUND_OFF));
        assertThat(dumbbell.smallestWidth()).isEqualTo(0.4, within(ROUND_OFF));
    }

    @Test
    void aPartWeighsByItsRelativeDensity() {
        Compound hammer =
                Compound.of(
                        Part.of(Polygon.box(0.1, 1)),
                        Part.of(Polygon.box(0.5, 0.2)).at(0, 0.6).relativeDensity(9));

        // 0.1 kg at 0 and 0.9 kg at 0.6 m.
        assertThat(hammer.massProperties(1).mass()).isEqualTo(1, within(ROUND_OFF));
        assertThat(hammer.centroidY()).isEqualTo(0.54, within(ROUND_OFF));
        double handle = 0.1 * (1.01 / 12 + 0.54 * 0.54);
        double head = 0.9 * (0.29 / 12 + 0.06 * 0.06);
        assertThat(hammer.massProperties(1).inertia()).isEqualTo(handle + head, within(ROUND_OFF));
    }

    @Test
    void whatWeighsNothingMovesNoCentre() {
        Compound sail =
                Compound.of(
                        Part.of(new Circle(0.5)),
                        Part.of(Polygon.box(0.2, 2)).at(3, 1).relativeDensity(0));

        assertThat(sail.centroidX()).isZero();
        assertThat(sail.massProperties(2)).isEqualTo(new Circle(0.5).massProperties(2));
        assertThat(sail.boundingRadius()).isEqualTo(Math.hypot(3.1, 2), within(ROUND_OFF));
    }

    /** The inertia about a centre d away from the natural one is m·d² more. */
    @Test
    void aCentreOfItsOwnShiftsTheOutline() {
        Compound tumbler = Compound.of(Part.of(new Circle(1))).centredAt(0, -0.5);
        MassProperties disc = new Circle(1).massProperties(1);

        assertThat(tumbler.massProperties(1).inertia())
                .isEqualTo(disc.inertia() + disc.mass() * 0.25, within(ROUND_OFF));
        assertThat(tumbler.outline(0).cornerY(0)).isEqualTo(0.5);
        assertThat(tumbler.boundingRadius()).isEqualTo(1.5);
    }

    @Test
    void partsTurnAboutTheirOwnCentres() {
        Compound turned =
                Compound.of(Part.of(Polygon.box(2, 0.2)).at(5, 5).angle(Math.PI / 2))
                        .centredAt(5, 5);
        Aabb bounds = new Aabb();
        turned.bounds(0, 0, 1, 0, bounds);

        assertThat(bounds.maxX).isEqualTo(0.1, within(ROUND_OFF));
        assertThat(bounds.maxY).isEqualTo(1, within(ROUND_OFF));
        turned.bounds(3, 4, 0, 1, bounds);
        assertThat(bounds.minX).isEqualTo(2, within(ROUND_OFF));
        assertThat(bounds.minY).isEqualTo(3.9, within(ROUND_OFF));
    }

    /** By throwing darts at it: the error of n throws is that of their mean, four times of it. */
    @Test
    void massAndInertiaAreThoseOfTheDartsThatHit() {
        Compound cross =
                Compound.of(
                        Part.of(Polygon.box(2, 0.4)).angle(0.3),
                        Part.of(new Capsule(0.5, 0.2)).at(0.1, 1.2).angle(1.1),
                        Part.of(new Circle(0.3)).at(-1.4, -0.9));
        Random random = new Random(7);
        int throwsOf = 200_000;
        double side = 2 * cross.boundingRadius();
        double hits = 0;
        double squares = 0;
        double fourths = 0;
        for (int i = 0; i < throwsOf; i++) {
            double x = side * (random.nextDouble() - 0.5);
            double y = side * (random.nextDouble() - 0.5);
            int covered = covered(cross, x, y);
            hits += covered;
            squares += covered * (x * x + y * y);
            fourths += covered * Math.pow(x * x + y * y, 2);
        }
        double share = side * side / throwsOf;
        assertThat(cross.massProperties(1).mass())
                .isEqualTo(hits * share, within(4 * share * Math.sqrt(hits)));
        assertThat(cross.massProperties(1).inertia())
                .isEqualTo(squares * share, within(4 * share * Math.sqrt(fourths)));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 257})
    void tooFewAndTooManyPartsAreRefused(int count) {
        assertThatThrownBy(() -> Compound.of(Collections.nCopies(count, Part.of(new Circle(1)))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Compound.of takes 1 to 256 parts, was " + count);
    }

    @Test
    void partsThatLeaveNoMassAreRefused() {
        assertThatThrownBy(() -> Compound.of(Part.of(new Circle(1)).relativeDensity(0)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("positive, finite mass");
    }

    @Test
    void placesThatAreNoneAreRefused() {
        Part part = Part.of(new Circle(1));
        assertThatThrownBy(() -> part.at(Double.NaN, 0)).hasMessageContaining("Part.x");
        assertThatThrownBy(() -> part.angle(1 / 0.0)).hasMessageContaining("Part.angle");
        assertThatThrownBy(() -> part.relativeDensity(-1)).hasMessageContaining("0 to 10⁶");
        assertThatThrownBy(() -> Part.of(null)).hasMessageContaining("Part.shape");
        assertThatThrownBy(() -> Compound.of(part).centredAt(0, Double.NaN))
                .hasMessageContaining("centredAt");
    }

    @Test
    void equalPartsMakeEqualCompounds() {
        assertThat(quarters(2, 1)).isEqualTo(quarters(2, 1)).hasSameHashCodeAs(quarters(2, 1));
        assertThat(quarters(2, 1)).isNotEqualTo(quarters(1, 2));
        assertThat(quarters(2, 1)).isNotEqualTo(quarters(2, 1).centredAt(0, 0.1));
    }

    private static Compound quarters(double width, double height) {
        Part quarter = Part.of(Polygon.box(width / 2, height / 2));
        double x = width / 4;
        double y = height / 4;
        return Compound.of(
                quarter.at(-x, -y), quarter.at(x, -y), quarter.at(x, y), quarter.at(-x, y));
    }

    /** By how many parts a point is covered. */
    private static int covered(Compound compound, double x, double y) {
        int count = 0;
        for (int part = 0; part < compound.parts(); part++) {
            Outline outline = compound.outline(part);
            double depth =
                    outline.isDisc()
                            ? outline.radius()
                                    - Math.hypot(x - outline.cornerX(0), y - outline.cornerY(0))
                            : outline.depth(x, y);
            count += depth >= 0 ? 1 : 0;
        }
        return count;
    }
}
