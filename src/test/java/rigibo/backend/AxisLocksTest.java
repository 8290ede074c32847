package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/** Bodies locked along x or y: along a locked axis they have infinite mass. */
class AxisLocksTest {

    private static final double DT = 1 / 60.0;
    private static final double G = 9.81;
    private static final Material SMOOTH = new Material(1000, 0, 0);
    private static final Effects SLIPPERY =
            Effects.usual().without(Friction.class).without(Sleep.class);

    /** Without the lock it would slide 12 m in that time; what holds it pushes along the slope. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatIsLockedInXDoesNotSlideDownASlope(Preset preset) {
        Pool pool = new Pool(SLIPPERY, preset.accuracy);
        double slope = Math.toRadians(30);
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).angle(slope).material(SMOOTH));
        double away = 1.0;
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(1, 1))
                                .at(-away * Math.sin(slope), away * Math.cos(slope))
                                .angle(slope)
                                .material(SMOOTH)
                                .lockX());
        double x = box.x();
        double y = box.y();
        for (int i = 0; i < 200; i++) {
            pool.step(DT);
            assertThat(box.velocityX()).isZero();
        }
        assertThat(box.x()).isEqualTo(x);
        // The overlap that is kept lest a contact tremble: 1e-5 of the box's width.
        assertThat(box.y()).isEqualTo(y, within(2e-5));
        assertThat(box.angle()).isEqualTo(slope, within(1e-5));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatIsLockedInYCarriesAPile(Preset preset) {
        Pool pool = new Pool(Effects.usual().without(Sleep.class), preset.accuracy);
        RigidBody shelf =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(3, 0.2))
                                .at(0, 5)
                                .lockY()
                                .lockRotation());
        List<RigidBody> boxes = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            boxes.add(
                    pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(0, 5.35 + i * 0.5)));
        }
        for (int i = 0; i < 300; i++) {
            pool.step(DT);
            assertThat(shelf.velocityY()).isZero();
        }
        assertThat(shelf.y()).isEqualTo(5);
        assertThat(shelf.x()).isEqualTo(0, within(1e-6));
        for (int i = 0; i < 5; i++) {
            // Each contact keeps an overlap of 1e-5 of half a metre; DRAFT solves less strictly.
            double kept = preset == Preset.DRAFT ? 5e-3 : 1e-4;
            assertThat(boxes.get(i).y()).isEqualTo(5.35 + i * 0.5, within(kept));
            assertThat(boxes.get(i).velocityY()).isEqualTo(0, within(1e-3));
        }
    }

    /** x = v·t + a·t²/2, and y to the bit. */
    @Test
    void discLockedInYFollowsItsRail() {
        Effects effects = Effects.usual().with(new Gravity(0.7, -G));
        Pool pool = new Pool(effects, Accuracy.GAME);
        RigidBody bead =
                pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(0, 1.1).velocity(2, 5).lockY());
        assertThat(bead.velocityY()).isZero();
        for (int i = 1; i <= 120; i++) {
            pool.step(DT);
            double t = i * DT;
            assertThat(bead.x()).isEqualTo(2 * t + 0.7 * t * t / 2, within(1e-12));
            assertThat(bead.velocityX()).isEqualTo(2 + 0.7 * t, within(1e-12));
            assertThat(bead.y()).isEqualTo(1.1);
            assertThat(bead.velocityY()).isZero();
        }
    }

    /**
     * j = −(1 + e)·vₙ / (nₓ²/m_a + 1/m_b): the bead gives way along x alone, the other along the
     * normal.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void impactCountsTheMassAlongTheFreeAxisAlone(Preset preset) {
        for (double degrees = 0; degrees < 90; degrees += 15) {
            Pool pool =
                    new Pool(
                            SLIPPERY.without(Gravity.class).without(Rotation.class),
                            preset.accuracy);
            double nx = Math.cos(Math.toRadians(degrees));
            double ny = Math.sin(Math.toRadians(degrees));
            Material elastic = new Material(1000, 0, 0.5);
            RigidBody bead =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(0.5))
                                    .mass(3)
                                    .material(elastic)
                                    .lockY());
            RigidBody ball =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(0.5))
                                    .mass(2)
                                    .material(elastic)
                                    .at(1.1 * nx, 1.1 * ny)
                                    .velocity(-4 * nx, -4 * ny));
            for (int i = 0; i < 10; i++) {
                pool.step(DT);
            }
            double impulse = 1.5 * 4 / (nx * nx / 3 + 1 / 2.0);
            // Bodies within the tolerance count as touching. The normal may turn by the tolerance
            // over the metre between the centres, and 4 m/s turn with it.
            double off = 4 * preset.accuracy.impactTolerance();
            assertThat(bead.velocityX()).isEqualTo(-impulse * nx / 3, within(off));
            assertThat(bead.velocityY()).isZero();
            assertThat(ball.velocityX()).isEqualTo(-4 * nx + impulse * nx / 2, within(off));
            assertThat(ball.velocityY()).isEqualTo(-4 * ny + impulse * ny / 2, within(off));
            assertThat(bead.y()).isZero();
        }
    }

    /**
     * A tappet locked in x (mass m) sinks on a wedge locked in y (mass M, slope α): a = m·g / (m +
     * M/tan²α), from N·sin α = M·a/tan α and m·g − N·cos α = m·a.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void tappetDrivesAWedgeByFormula(Preset preset) {
        Pool pool = new Pool(SLIPPERY, preset.accuracy);
        Polygon slope = Polygon.of(-3, -1, 3, -1, -3, 2);
        double tan = 0.5;
        double m = 2;
        double wedgeMass = 5;
        RigidBody wedge =
                pool.add(
                        BodyDefinition.dynamic(slope)
                                .mass(wedgeMass)
                                .material(SMOOTH)
                                .lockY()
                                .lockRotation());
        double r = 0.25;
        double cos = 1 / Math.sqrt(1 + tan * tan);
        // The slope's height over the wedge's centre, from its upper corner.
        double surface = slope.cornerY(2) + tan * slope.cornerX(2);
        RigidBody tappet =
                pool.add(
                        BodyDefinition.dynamic(new Circle(r))
                                .mass(m)
                                .material(SMOOTH)
                                .at(0, surface + r / cos)
                                .lockX());
        double y = tappet.y();
        for (int i = 0; i < 30; i++) {
            pool.step(DT);
        }
        double t = 30 * DT;
        double a = m * G / (m + wedgeMass / (tan * tan));
        assertThat(tappet.velocityX()).isZero();
        assertThat(wedge.velocityY()).isZero();
        assertThat(tappet.velocityY()).isEqualTo(-a * t, within(1e-3 * a * t));
        assertThat(wedge.velocityX()).isEqualTo(-a * t / tan, within(1e-3 * a * t / tan));
        assertThat(tappet.y()).isEqualTo(y - a * t * t / 2, within(1e-3 * a * t * t / 2));
    }

    /** With rubbing v = m·v₀/(m + M) in the end: nothing but the two bodies bears the friction. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void boxAndTrolleyComeToShareTheMomentum(Preset preset) {
        Pool pool = new Pool(Effects.usual().without(Sleep.class), preset.accuracy);
        RigidBody trolley =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(20, 0.2))
                                .mass(3)
                                .lockY()
                                .lockRotation());
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(1, 0.4))
                                .mass(2)
                                .at(-5, 0.3)
                                .velocity(4, 0));
        for (int i = 0; i < 180; i++) {
            pool.step(DT);
            double momentum = 3 * trolley.velocityX() + 2 * box.velocityX();
            // Sums of impulses that are each applied to both alike, rounded.
            assertThat(momentum).isEqualTo(8, within(1e-10));
        }
        assertThat(box.velocityX()).isEqualTo(8 / 5.0, within(1e-4));
        assertThat(trolley.velocityX()).isEqualTo(8 / 5.0, within(1e-4));
        assertThat(trolley.y()).isZero();
    }

    /** A thin plate on rails stops a bullet, which goes on with it by their momentum. */
    @Test
    void nothingFliesThroughWhatIsLocked() {
        for (double speed : new double[] {10, 100, 1000}) {
            Pool pool = new Pool(SLIPPERY.without(Gravity.class), Accuracy.GAME);
            RigidBody plate =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.05, 2))
                                    .mass(4)
                                    .material(SMOOTH)
                                    .lockY()
                                    .lockRotation());
            RigidBody bullet =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(0.05))
                                    .mass(1)
                                    .material(SMOOTH)
                                    .at(-3.3, 0.5)
                                    .velocity(speed, 0));
            for (int i = 0; i < 60; i++) {
                pool.step(DT);
                assertThat(bullet.x()).isLessThan(plate.x() - 0.074);
            }
            assertThat(plate.velocityX()).isEqualTo(speed / 5, within(1e-9 * speed));
            assertThat(plate.y()).isZero();
        }
    }

    /** Locked all round it is as good as fixed, and one on top of it rests as on the ground. */
    @Test
    void whatIsLockedAllRoundStandsLikeTheGround() {
        Pool pool = new Pool(Effects.usual().without(Sleep.class), Accuracy.GAME);
        RigidBody rock =
                pool.add(BodyDefinition.dynamic(Polygon.box(2, 1)).lockX().lockY().lockRotation());
        RigidBody box =
                pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(0.9, 1).velocity(0, -3));
        for (int i = 0; i < 120; i++) {
            pool.step(DT);
        }
        assertThat(rock.x()).isZero();
        assertThat(rock.y()).isZero();
        assertThat(rock.angle()).isZero();
        assertThat(rock.kineticEnergy()).isZero();
        assertThat(box.y()).isEqualTo(0.75, within(1e-5));
        assertThat(box.velocityY()).isEqualTo(0, within(1e-9));
    }

    /** Forces that change along the way, drag and impulses do nothing along a locked axis. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void noForceMovesABodyAlongItsLockedAxis(Preset preset) {
        Effects[] sets = {
            Effects.of(new CentralForce(0, 0, 3, 1), new Drag()),
            Effects.of(new CentralForce(0, 0, 3, 1), new Contacts(), new Rotation()),
            Effects.of(new Gravity(0, -G), new Rotation())
        };
        for (Effects effects : sets) {
            Pool pool = new Pool(effects, preset.accuracy);
            RigidBody bead =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(0.2))
                                    .at(1, 2)
                                    .lockY()
                                    .velocity(1, 1));
            bead.applyImpulse(0, 5, 1, 2);
            for (int i = 0; i < 100; i++) {
                pool.step(DT);
                assertThat(bead.velocityY()).isZero();
            }
            assertThat(bead.y()).isEqualTo(2);
            assertThat(bead.x()).isNotEqualTo(1);
        }
    }

    /** A bead on a rail pulled by s·distance swings as x″ = −s·x, however far the rail is. */
    @Test
    void beadOnARailSwingsByItsWayAlongTheRailAlone() {
        double stiffness = 3;
        Effects effects = Effects.of(new CentralForce(0, 0, stiffness, 1), new Contacts());
        Pool pool = new Pool(effects, Accuracy.EXACT);
        RigidBody bead = pool.add(BodyDefinition.dynamic(new Circle(0.2)).mass(2).at(1, 2).lockY());
        double omega = Math.sqrt(stiffness);
        for (int i = 1; i <= 300; i++) {
            pool.step(DT);
            // A leapfrog of 16 substeps is off by (ω·h)²/24 of the phase: 1.4e-7 a radian.
            assertThat(bead.x()).isEqualTo(Math.cos(omega * i * DT), within(2e-6));
        }
    }

    /**
     * Elastic and smooth, so that impacts take no energy, wherever in a step they come: a body that
     * joins the locked body's island within the step is accelerated only from then on.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatFliesIntoALockedBodyKeepsItsEnergy(Preset preset) {
        for (int i = 0; i < 40; i++) {
            Material elastic = new Material(1, 0, 1);
            Pool pool = new Pool(SLIPPERY, preset.accuracy);
            pool.add(BodyDefinition.dynamic(new Circle(0.5)).material(elastic).lockY());
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.3))
                            .at(-3, 0.4)
                            .velocity(5 + 0.1 * i, 2)
                            .material(elastic));
            double before = pool.kineticEnergy() + pool.potentialEnergy();
            int impacts = 0;
            for (int step = 0; step < 60; step++) {
                impacts += pool.step(DT).impacts();
                double now = pool.kineticEnergy() + pool.potentialEnergy();
                // DRAFT does not place impacts within a step; all others follow parabolas exactly.
                double error = preset == Preset.DRAFT ? 1e-2 : 1e-9;
                assertThat(now).as("speed %d, step %d", i, step).isEqualTo(before, within(error));
            }
            assertThat(impacts).isEqualTo(1);
        }
    }
}
