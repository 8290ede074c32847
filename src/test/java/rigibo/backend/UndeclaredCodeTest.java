package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;

/** The code of an undeclared effect is not even loaded; told by a Java of its own. */
class UndeclaredCodeTest {

    /** Where effects do what they do. Their records are known to whoever asks for them. */
    private static final List<String> KERNELS =
            List.of(
                    "force",
                    "flight",
                    "impact",
                    "contact",
                    "rest",
                    "sense",
                    "broadphase",
                    "collision",
                    "step");

    /** Runs a pool with gravity and the named effects. */
    public static void main(String[] arguments) {
        Effects effects = Effects.of(new Gravity(0, -9.81));
        for (String name : arguments) {
            effects = effects.with(named(name));
        }
        Pool pool = new Pool(effects, Accuracy.GAME);
        Scenes.addFloor(pool);
        pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(0, 1));
        Scenes.run(pool, 120);
    }

    private static Effect named(String name) {
        return Effects.usual().all().stream()
                .filter(effect -> effect.title().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** The classes of the effects that are forces, whatever else is declared. */
    private static final String[] FORCES = {
        "force.ThrustKernel",
        "force.TorqueKernel",
        "force.WindKernel",
        "force.GustForce",
        "force.AirDragForce",
        "force.BuoyantForce",
        "force.Submerged",
        "force.CentralPull",
        "force.FanForce",
        "force.MagnetForce",
        "force.Extent",
        "force.FieldForce",
        "force.Instant",
        "flight.Course",
        "flight.Deviation",
        "flight.TurningCourse",
        "contact.row.IslandForces",
        "contact.row.DragKick"
    };

    /** The classes of locked axes, which a locked body needs, not an effect. */
    private static final String[] LOCKS = {
        "force.LockedAxesKernel",
        "force.LockedAxesForce",
        "rest.LockedBodies",
        "contact.row.LockedAxes",
        "contact.joint.RowOverlap",
        "contact.JointedIslands"
    };

    /** The classes of rotation. */
    private static final String[] TURNING = {
        "contact.row.PackedTurns",
        "contact.row.TurningRows",
        "flight.OpenTurning",
        "flight.TurningPaths",
        "step.StepTurns"
    };

    @Test
    void usualPoolLoadsNoKernelOfTheOtherEffects() throws IOException, InterruptedException {
        List<String> usual =
                Effects.usual().all().stream().map(Effect::title).collect(Collectors.toList());
        assertThat(loaded(usual.toArray(new String[0])))
                .contains(
                        "force.GravityKernel",
                        "contact.solve.FrictionSolver",
                        "contact.row.PackedTurns",
                        "contact.row.TurningRows",
                        "contact.bounce.IslandImpacts",
                        "flight.Flight",
                        "flight.TurningPaths",
                        "step.StepTurns",
                        "rest.Sleeping")
                .doesNotContain(FORCES)
                .doesNotContain(LOCKS)
                .doesNotContain("contact.solve.RollingSolver", "contact.row.RunningRows");
    }

    @Test
    void contactsAloneLoadNothingOfWhatBuildsOnThem() throws IOException, InterruptedException {
        assertThat(loaded("contacts"))
                .contains("contact.IslandSolver", "contact.solve.NoRubbing", "flight.FreeFlight")
                .doesNotContain(FORCES)
                .doesNotContain(TURNING)
                .doesNotContain(
                        "contact.solve.FrictionSolver",
                        "contact.solve.RollingSolver",
                        "contact.row.RunningRows",
                        "contact.bounce.IslandImpacts",
                        "contact.bounce.BounceRows",
                        "contact.bounce.SimultaneousImpacts",
                        "contact.bounce.PairwiseImpacts",
                        "flight.Flight",
                        "flight.FlightImpacts",
                        "flight.Bystanders",
                        "flight.ImpactQueue",
                        "collision.distance.TimeOfImpact",
                        "rest.Sleeping");
    }

    @Test
    void flightAloneLoadsNothingOfContacts() throws IOException, InterruptedException {
        assertThat(loaded())
                .contains("flight.OpenFlight", "force.GravityKernel")
                .doesNotContain(FORCES)
                .doesNotContain(TURNING)
                .noneMatch(name -> name.startsWith("contact.") || name.startsWith("impact."))
                .noneMatch(name -> name.startsWith("broadphase."))
                .doesNotContain(
                        "flight.Flight",
                        "flight.FreeFlight",
                        "flight.Trajectories",
                        "collision.Narrowphase",
                        "collision.manifold.Collider",
                        "rest.PileClassifier",
                        "rest.IslandBuilder",
                        "rest.Sleeping");
    }

    private static List<String> loaded(String... arguments)
            throws IOException, InterruptedException {
        String log =
                ChildJvm.output(
                        ChildJvm.own(),
                        List.of("-Xlog:class+load=info:stdout:none"),
                        UndeclaredCodeTest.class,
                        arguments);
        return log.lines()
                .map(line -> line.split(" ")[0])
                .filter(name -> KERNELS.stream().anyMatch(room -> isIn(room, name)))
                .map(name -> name.substring("rigibo.backend.".length()))
                .collect(Collectors.toList());
    }

    private static boolean isIn(String room, String name) {
        return name.startsWith("rigibo.backend." + room + ".");
    }
}
