package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

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
            List.of("force", "flight", "impact", "contact", "rest", "broadphase", "collision");

    /** What is run: a pool of gravity alone, or the usual one. */
    public static void main(String[] arguments) {
        boolean isUsual = arguments.length > 0;
        Pool pool =
                isUsual ? new Pool() : new Pool(Effects.of(new Gravity(0, -9.81)), Accuracy.GAME);
        if (isUsual) {
            Scenes.addFloor(pool);
        }
        pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(0, 1));
        Scenes.run(pool, 120);
    }

    @Test
    void usualPoolLoadsNoKernelOfTheOtherEffects() throws IOException, InterruptedException {
        assertThat(loaded("usual"))
                .contains("force.GravityKernel", "contact.FrictionSolver", "rest.Sleeping")
                .doesNotContain(
                        "force.ThrustKernel",
                        "force.WindKernel",
                        "force.GustForce",
                        "force.AirDragForce",
                        "force.BuoyantForce",
                        "force.Submerged",
                        "force.CentralPull",
                        "force.FieldForce",
                        "force.Instant",
                        "flight.Course",
                        "flight.Deviation",
                        "contact.PileForces");
    }

    @Test
    void flightAloneLoadsNothingOfContacts() throws IOException, InterruptedException {
        assertThat(loaded())
                .contains("flight.Flight", "force.GravityKernel")
                .doesNotContain(
                        "contact.PileSolver",
                        "contact.FrictionSolver",
                        "rest.PileClassifier",
                        "rest.IslandBuilder",
                        "rest.Sleeping",
                        "force.ThrustKernel",
                        "flight.Course");
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
