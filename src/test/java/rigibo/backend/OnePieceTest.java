package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** A body of several parts behaves like a body in one piece with the same outline. */
class OnePieceTest {

    private static final double DT = 1 / 60.0;
    private static final Effects AWAKE = Effects.usual().without(Sleep.class);

    private static final Polygon BOX = Polygon.box(1, 0.8);

    private static final Compound FOUR_BOXES =
            Compound.of(
                    Part.of(Polygon.box(0.5, 0.4)).at(-0.25, -0.2),
                    Part.of(Polygon.box(0.5, 0.4)).at(0.25, -0.2),
                    Part.of(Polygon.box(0.5, 0.4)).at(0.25, 0.2),
                    Part.of(Polygon.box(0.5, 0.4)).at(-0.25, 0.2));

    private static Pool thrown(Shape shape, Material material) {
        Pool pool = new Pool(AWAKE, Accuracy.FINE);
        pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5).material(material));
        pool.add(
                BodyDefinition.dynamic(shape)
                        .at(0, 3)
                        .angle(0.3)
                        .velocity(2, 1)
                        .spin(1.5)
                        .material(material));
        return pool;
    }

    /** In flight and in its first bounce there is one outline: the parts' corners lie on it. */
    @Test
    void aBoxOfFourBoxesFliesAndBouncesAsTheBox() {
        Material elastic = new Material(1, 0.3, 0.5);
        Pool whole = thrown(BOX, elastic);
        Pool parts = thrown(FOUR_BOXES, elastic);
        RigidBody box = whole.bodies().get(1);
        RigidBody four = parts.bodies().get(1);
        assertThat(four.inertia()).isEqualTo(box.inertia(), within(1e-15));
        for (int i = 0; i < 60; i++) {
            whole.step(DT);
            parts.step(DT);
            // Both meet the floor to round-off of the tolerance of impacts, 1e-7 of a width.
            assertThat(four.x()).as("step %d", i).isEqualTo(box.x(), within(1e-6));
            assertThat(four.y()).isEqualTo(box.y(), within(1e-6));
            assertThat(four.angle()).isEqualTo(box.angle(), within(1e-6));
        }
        assertThat(box.velocityY()).as("has bounced").isGreaterThan(-5);
    }

    /** At rest it stands as high, and its corners carry half of its weight each. */
    @Test
    void aBoxOfFourBoxesStandsAsTheBox() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5));
        for (int i = 0; i < 5; i++) {
            pool.add(BodyDefinition.dynamic(FOUR_BOXES).at(0, 0.4 + 0.8 * i));
        }
        for (int i = 0; i < 300; i++) {
            pool.step(DT);
        }
        for (int i = 0; i < 5; i++) {
            RigidBody box = pool.bodies().get(i + 1);
            assertThat(box.y()).isEqualTo(0.4 + 0.8 * i, within(1e-3 * (i + 1)));
            assertThat(box.x()).isEqualTo(0, within(1e-3));
            assertThat(box.angle()).isEqualTo(0, within(1e-3));
        }
        double[] carried = new double[1];
        pool.forEachContact(
                contact -> {
                    if (contact.a == pool.bodies().get(0)) {
                        for (int i = 0; i < contact.points; i++) {
                            carried[0] += contact.force[i];
                        }
                    }
                });
        assertThat(carried[0]).isEqualTo(5 * 0.8 * 9.81, within(1e-3 * 5 * 0.8 * 9.81));
    }

    /**
     * Each box stands across the seam of two halves, and its own halves across that of two boxes:
     * no corner inside of a box pushes sideways, so that nothing moves from the first step on.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aPyramidOfHalvesStandsFromTheFirstStepOn(boolean isCutAcross) {
        Compound halves =
                isCutAcross
                        ? Compound.of(
                                Part.of(Polygon.box(1, 0.5)).at(0, -0.25),
                                Part.of(Polygon.box(1, 0.5)).at(0, 0.25))
                        : Compound.of(
                                Part.of(Polygon.box(0.5, 1)).at(-0.25, 0),
                                Part.of(Polygon.box(0.5, 1)).at(0.25, 0));
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5));
        int base = 20;
        for (int i = 0; i < base * base; i++) {
            int storey = i / base;
            if (i % base < base - storey) {
                double x = i % base - (base - storey - 1) / 2.0;
                pool.add(BodyDefinition.dynamic(halves).at(x, storey + 0.5));
            }
        }
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
            for (RigidBody body : pool.bodies()) {
                assertThat(Math.hypot(body.velocityX(), body.velocityY()))
                        .as("step %d", i)
                        .isLessThan(1e-6);
            }
        }
    }

    /**
     * Boxes of 1 m set down up to 5 mm beside each other and 1 mm above: each lies on up to six
     * points, of which the outer two carry it, as they do the box in one piece. It may move by what
     * it lands askew; 2 mm is the limit of the stack in one piece.
     */
    @ParameterizedTest
    @ValueSource(ints = {3, 8, 12})
    void aStackOfPartsSetDownCarelesslyStands(int count) {
        Compound halves =
                Compound.of(
                        Part.of(Polygon.box(0.5, 1)).at(-0.25, 0),
                        Part.of(Polygon.box(0.5, 1)).at(0.25, 0));
        Compound quarters =
                Compound.of(
                        Part.of(Polygon.box(0.5, 0.5)).at(-0.25, -0.25),
                        Part.of(Polygon.box(0.5, 0.5)).at(0.25, -0.25),
                        Part.of(Polygon.box(0.5, 0.5)).at(0.25, 0.25),
                        Part.of(Polygon.box(0.5, 0.5)).at(-0.25, 0.25));
        for (Compound shape : new Compound[] {halves, quarters}) {
            SplittableRandom random = new SplittableRandom(count);
            Pool pool = new Pool(AWAKE, Accuracy.GAME);
            pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5));
            List<RigidBody> stack = new ArrayList<>();
            double[] x = new double[count];
            double top = 0;
            for (int i = 0; i < count; i++) {
                x[i] = random.nextDouble(-5e-3, 5e-3);
                top += 1 + random.nextDouble(1e-3);
                stack.add(pool.add(BodyDefinition.dynamic(shape).at(x[i], top - 0.5)));
            }
            for (int step = 0; step < 300; step++) {
                pool.step(DT);
            }
            for (int i = 0; i < count; i++) {
                RigidBody box = stack.get(i);
                assertThat(box.x()).as("%s, %s", shape, box).isEqualTo(x[i], within(2e-3));
                assertThat(box.y()).isEqualTo(i + 0.5, within(6e-3 * (i + 1)));
                assertThat(Math.hypot(box.velocityX(), box.velocityY())).isLessThan(1e-5);
            }
        }
    }

    /**
     * Bodies that begin at nearly one spot, without weight: no part leaves another through a face
     * behind which the next one begins, so that all part, no faster than three widths a second.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-3, 0.1})
    void partsThatOverlapDeeplyLeaveEachOther(double off) {
        Compound angle =
                Compound.of(
                        Part.of(Polygon.box(0.8, 0.2)),
                        Part.of(Polygon.box(0.2, 0.5)).at(-0.3, 0.35));
        Compound cross =
                Compound.of(
                        Part.of(Polygon.box(0.3, 0.3)),
                        Part.of(Polygon.box(0.3, 0.2)).at(-0.3, 0),
                        Part.of(Polygon.box(0.3, 0.2)).at(0.3, 0),
                        Part.of(Polygon.box(0.2, 0.3)).at(0, -0.3),
                        Part.of(Polygon.box(0.2, 0.3)).at(0, 0.3));
        Compound cut = Compound.ofOutline(0, 0, 1, 0, 1, 0.3, 0.3, 0.3, 0.3, 1, 0, 1);
        for (Compound shape : new Compound[] {FOUR_BOXES, angle, cross, cut}) {
            SplittableRandom random = new SplittableRandom(1);
            Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
            for (int i = 0; i < 4; i++) {
                double x = off * random.nextDouble(-1, 1);
                double y = off * random.nextDouble(-1, 1);
                pool.add(BodyDefinition.dynamic(shape).at(x, y).angle(0.3));
            }
            double most = 3 * shape.smallestWidth() * DT;
            for (int step = 0; step < 600; step++) {
                double[] x = pool.bodies().stream().mapToDouble(RigidBody::x).toArray();
                double[] y = pool.bodies().stream().mapToDouble(RigidBody::y).toArray();
                pool.step(DT);
                for (int i = 0; i < x.length; i++) {
                    RigidBody body = pool.bodies().get(i);
                    assertThat(Math.hypot(body.x() - x[i], body.y() - y[i]))
                            .as("%s, step %d", shape, step)
                            .isLessThan(most);
                }
            }
            assertThat(pool.report().deepestOverlap())
                    .as("%s", shape)
                    .isLessThan(0.005 * shape.smallestWidth());
            assertThat(pool.kineticEnergy()).isLessThan(1e-9);
        }
    }

    /** Every part that stands on the floor is told to touch it, also one that carries nothing. */
    @Test
    void partsBetweenTwoOthersAreToldToTouch() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5));
        Compound row =
                Compound.of(
                        Part.of(Polygon.box(0.5, 0.4)).at(-1, 0),
                        Part.of(Polygon.box(0.5, 0.4)),
                        Part.of(Polygon.box(0.5, 0.4)).at(1, 0));
        RigidBody body = pool.add(BodyDefinition.dynamic(row).at(0, 0.2));
        double[] carried = new double[1];
        for (int step = 0; step < 60; step++) {
            pool.step(DT);
            List<Integer> parts = new ArrayList<>();
            carried[0] = 0;
            pool.forEachContact(
                    contact -> {
                        parts.add(contact.partB);
                        assertThat(contact.phase == Phase.BEGIN).isEqualTo(pool.time() < 1.5 * DT);
                        assertThat(contact.y).isEqualTo(0, within(1e-3));
                        assertThat(contact.x).isEqualTo(contact.partB - 1, within(0.3));
                        for (int i = 0; i < contact.points; i++) {
                            carried[0] += contact.force[i];
                        }
                    });
            assertThat(parts).containsExactlyInAnyOrder(0, 1, 2);
            assertThat(pool.touching(floor, body)).isTrue();
        }
        double weight = body.mass() * 9.81;
        assertThat(carried[0]).isEqualTo(weight, within(1e-3 * weight));
    }

    /** The smaller ones lie within: they touch nothing, and weigh nothing here. */
    @Test
    void aDiscWithSmallerDiscsInItRollsAsTheDisc() {
        Compound filled =
                Compound.of(
                        Part.of(new Circle(0.5)),
                        Part.of(new Circle(0.2)).at(0.2, 0.1).relativeDensity(0),
                        Part.of(new Circle(0.1)).at(-0.3, -0.2).relativeDensity(0));
        Material rough = new Material(1, 0.6, 0.2);
        Pool plain = thrown(new Circle(0.5), rough);
        Pool parts = thrown(filled, rough);
        for (int i = 0; i < 240; i++) {
            plain.step(DT);
            parts.step(DT);
        }
        RigidBody disc = plain.bodies().get(1);
        RigidBody three = parts.bodies().get(1);
        assertThat(three.mass()).isEqualTo(disc.mass());
        // The plain disc takes shortcuts that one of several parts does not: within the tolerance.
        assertThat(three.y()).isEqualTo(disc.y(), within(1e-3));
        assertThat(three.velocityX()).isEqualTo(disc.velocityX(), within(0.01));
        assertThat(three.angularVelocity()).isEqualTo(disc.angularVelocity(), within(0.02));
        assertThat(three.velocityX()).isEqualTo(-0.5 * three.angularVelocity(), within(0.01));
    }

    /** A wheel of 256 corners that rolls down a slope, in one piece and as 256 wedges. */
    @Test
    void aWheelOfWedgesRollsAsTheWheel() {
        Polygon wheel = Polygon.regular(256, 0.5);
        List<Part> wedges = new ArrayList<>();
        for (int i = 0; i < 256; i++) {
            int next = (i + 1) % 256;
            Polygon wedge =
                    Polygon.of(
                            0,
                            0,
                            wheel.cornerX(i),
                            wheel.cornerY(i),
                            wheel.cornerX(next),
                            wheel.cornerY(next));
            wedges.add(Part.of(wedge).at(wedge.centroidX(), wedge.centroidY()));
        }
        Compound parts = Compound.of(wedges);
        double inertia = wheel.massProperties(1).inertia();
        assertThat(parts.massProperties(1).inertia()).isEqualTo(inertia, within(1e-12));
        double[] way = new double[2];
        for (int k = 0; k < 2; k++) {
            Pool pool = new Pool(AWAKE, Accuracy.GAME);
            pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5).angle(-0.2));
            RigidBody body =
                    pool.add(
                            BodyDefinition.dynamic(k == 0 ? wheel : parts)
                                    .material(new Material(1, 0.9, 0)));
            // Half of the plate's height and the wheel's radius from the middle of the plate.
            body.moveTo(Math.sin(0.2), Math.cos(0.2) - 0.5, 0);
            for (int i = 0; i < 120; i++) {
                pool.step(DT);
            }
            way[k] = Math.hypot(body.x() - Math.sin(0.2), body.y() - Math.cos(0.2) + 0.5);
        }
        // Rolling of a disc: a = 2/3·g·sin β; corners cost it up to 1 %, either way alike.
        double expected = 9.81 * Math.sin(0.2) / 3 * 4;
        assertThat(way[0]).isEqualTo(expected, within(0.02 * expected));
        assertThat(way[1]).isEqualTo(expected, within(0.02 * expected));
    }

    /** A capsule of no length is a disc, and its pool goes on to the same bits. */
    @Test
    void aCapsuleOfNoLengthIsACircleToTheBit() {
        Material matter = new Material(1, 0.4, 0.3);
        Pool discs = new Pool(AWAKE, Accuracy.GAME);
        Pool capsules = new Pool(AWAKE, Accuracy.GAME);
        for (Pool pool : List.of(discs, capsules)) {
            pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
            for (int i = 0; i < 40; i++) {
                Shape shape = pool == discs ? new Circle(0.3) : new Capsule(0, 0.3);
                pool.add(
                        BodyDefinition.dynamic(shape)
                                .at(i % 7 * 0.65 - 2, 0.5 + i / 7 * 0.7)
                                .velocity(i % 3, 0)
                                .material(matter));
            }
        }
        for (int step = 0; step < 200; step++) {
            discs.step(DT);
            capsules.step(DT);
        }
        for (int i = 0; i < discs.bodies().size(); i++) {
            RigidBody disc = discs.bodies().get(i);
            RigidBody capsule = capsules.bodies().get(i);
            assertThat(capsule.x()).isEqualTo(disc.x());
            assertThat(capsule.y()).isEqualTo(disc.y());
            assertThat(capsule.angle()).isEqualTo(disc.angle());
            assertThat(capsule.velocityX()).isEqualTo(disc.velocityX());
        }
    }
}
