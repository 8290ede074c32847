package rigibo.lab.ablation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Thrust;
import rigibo.lab.ablation.probe.Probe;
import rigibo.lab.ablation.probe.Workloads;
import rigibo.lab.child.ClassFiles;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** The listed classes are those of this build, and none is loaded where nobody needs it. */
class OwnClassesTest {

    private static final ClassFiles ENGINE = ClassFiles.of(Pool.class);

    @Test
    void everyListedClassIsBuilt() {
        assertThat(OwnClasses.undeclared(Effects.of(), ENGINE.names()))
                .contains(
                        "rigibo/backend/force/GravityKernel.class",
                        "rigibo/backend/contact/IslandSolver.class");
    }

    @Test
    void declaredEffectsKeepTheirOwn() {
        assertThat(OwnClasses.undeclared(Effects.usual().with(new Thrust()), ENGINE.names()))
                .contains(
                        "rigibo/backend/force/WindKernel.class",
                        "rigibo/backend/flight/Course.class",
                        "rigibo/backend/contact/row/IslandForces.class")
                .doesNotContain(
                        "rigibo/backend/force/ThrustKernel.class",
                        "rigibo/backend/contact/IslandSolver.class",
                        "rigibo/backend/rest/Sleeping.class");
    }

    @Test
    void missingClassIsNamedWithItsEffect() {
        List<String> engine = List.of("rigibo/backend/force/GravityKernel.class");
        Effects effects = Effects.of(new Gravity(0, -9.81));
        assertThatThrownBy(() -> OwnClasses.undeclared(effects, engine))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("force.ThrustKernel")
                .hasMessageContaining("Thrust");
    }

    @ParameterizedTest
    @ValueSource(strings = {"flyers", "wheel", "friction"})
    void undeclaredClassesAreNotLoaded(String scene) throws IOException, InterruptedException {
        List<String> undeclared =
                OwnClasses.undeclared(new Workloads(1).scene(scene).effects(), ENGINE.names());
        assertThat(loaded(scene))
                .contains("rigibo/backend/Pool.class")
                .doesNotContainAnyElementsOf(undeclared);
    }

    private static List<String> loaded(String scene) throws IOException, InterruptedException {
        Process process =
                new ProcessBuilder(
                                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                                "-Xlog:class+load=info:stdout:none",
                                "-cp",
                                System.getProperty("java.class.path"),
                                Probe.class.getName(),
                                scene,
                                "1",
                                "0",
                                "0")
                        .redirectErrorStream(true)
                        .start();
        String log = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(log).isZero();
        return log.lines()
                .map(line -> line.split(" ")[0])
                .filter(name -> name.startsWith("rigibo.backend."))
                .map(name -> name.replace('.', '/') + ".class")
                .toList();
    }
}
