package rigibo.frontend.scene.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;
import rigibo.backend.setup.Material;

/** The parts of a pool's energy, and what the declared effects may do to it. */
class EnergyTest {

    private static final Gravity GRAVITY = new Gravity(0, -10);
    private static final Effects ELASTIC =
            Effects.of(GRAVITY, new Contacts(), new Rotation(), new Restitution());

    private static Pool pool(Effects effects, double elasticity) {
        Pool pool = new Pool(effects, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(9, 1)));
        pool.add(
                BodyDefinition.dynamic(new Circle(0.5))
                        .at(0, 3)
                        .mass(2)
                        .inertia(0.5)
                        .velocity(3, 4)
                        .spin(6)
                        .material(new Material(1, 0, elasticity)));
        return pool;
    }

    /** m g h = 2·10·3, ½ m v² = 25, ½ I ω² = ½·0.5·36. */
    @Test
    void partsAreTheTextbooksAndAddUpToThePools() {
        Pool pool = pool(ELASTIC, 1);
        Energy energy = Energy.of(pool);
        assertThat(energy.potential()).isCloseTo(60, within(1e-12));
        assertThat(energy.translational()).isCloseTo(25, within(1e-12));
        assertThat(energy.rotational()).isCloseTo(9, within(1e-12));
        assertThat(energy.total())
                .isCloseTo(pool.kineticEnergy() + pool.potentialEnergy(), within(1e-12));
    }

    @Test
    void perfectlyElasticBodiesConserve() {
        assertThat(EnergyKind.of(pool(ELASTIC, 1))).isEqualTo(EnergyKind.CONSERVED);
    }

    @Test
    void bodiesThatMeetNobodyConserve() {
        assertThat(EnergyKind.of(pool(Effects.of(GRAVITY), 0))).isEqualTo(EnergyKind.CONSERVED);
    }

    @Test
    void whatTakesEnergyMakesItALoss() {
        Effects dull = Effects.of(GRAVITY, new Contacts());
        assertThat(EnergyKind.of(pool(ELASTIC, 0.9))).isEqualTo(EnergyKind.LOSING);
        assertThat(EnergyKind.of(pool(dull, 1))).as("e = 0").isEqualTo(EnergyKind.LOSING);
        assertThat(EnergyKind.of(pool(ELASTIC.with(new Friction()), 1)))
                .isEqualTo(EnergyKind.LOSING);
    }

    @Test
    void whatGivesEnergyMakesItWork() {
        Pool driven = pool(ELASTIC, 1);
        driven.add(BodyDefinition.kinematic(Polygon.box(1, 1)).at(0, 9));
        assertThat(EnergyKind.of(driven)).isEqualTo(EnergyKind.WORKED);
        assertThat(EnergyKind.of(pool(ELASTIC.with(new Thrust()), 1))).isEqualTo(EnergyKind.WORKED);
    }

    @Test
    void motorsAndSpringsWorkAndBrakesDoNot() {
        assertThat(EnergyKind.of(hinged(JointSettings.NONE))).isEqualTo(EnergyKind.CONSERVED);
        JointSettings motor = JointSettings.NONE.motor(new JointMotor(2, 5));
        assertThat(EnergyKind.of(hinged(motor))).isEqualTo(EnergyKind.WORKED);
        JointSettings spring = JointSettings.NONE.spring(new JointSpring(2, 0));
        assertThat(EnergyKind.of(hinged(spring))).isEqualTo(EnergyKind.WORKED);
        JointSettings brake = JointSettings.NONE.motor(new JointMotor(0, 5));
        assertThat(EnergyKind.of(hinged(brake))).isEqualTo(EnergyKind.LOSING);
    }

    /** A disc that hangs from a wall. */
    private static Pool hinged(JointSettings settings) {
        Pool pool = new Pool(ELASTIC.with(new Joints()), Accuracy.GAME);
        RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(1, 1)));
        RigidBody disc =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.5))
                                .at(3, 0)
                                .material(new Material(1, 0, 1)));
        pool.join(RevoluteJoint.at(wall, disc, 0, 0).with(settings));
        return pool;
    }
}
