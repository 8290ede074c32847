package rigibo.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.backend.Pool;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** The engine without the game, as its jar holds it, is enough for the example of the README. */
class EngineAloneTest {

    private static final Path EXAMPLE =
            Path.of("src/examples/java/rigibo/examples/FallingCrate.java");

    private static final Path TUTORIAL = Path.of("src/examples/java/rigibo/tutorial");

    @TempDir private static Path engine;
    @TempDir private Path compiled;

    /** Its classes apart from all others, and the declaration that makes a module of them. */
    @BeforeAll
    static void setApart() throws IOException, URISyntaxException {
        assumeTrue(JdkTool.isThere("javac"), "this Java has no compiler");
        Path all = Path.of(Pool.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        try (Stream<Path> files = Files.walk(all.resolve("rigibo/backend"))) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path copy = engine.resolve(all.relativize(file).toString());
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
            }
        }
        String patch = "rigibo.backend=" + engine;
        String declaration = "src/engine/java/module-info.java";
        run("javac", "--release", "17", "--patch-module", patch, "-d", "" + engine, declaration);
    }

    /** As {@code ./rigibo install} compiles it, which no other build does. */
    @Test
    void compilesAsAModuleWithoutAWarning() throws IOException {
        String lint = "-Xlint:all,-processing,-classfile,-serial,-missing-explicit-ctor";
        List<String> command =
                new ArrayList<>(
                        List.of(
                                "--release",
                                "17",
                                lint,
                                "-Werror",
                                "-cp",
                                "",
                                "-d",
                                "" + compiled));
        command.add("src/engine/java/module-info.java");
        try (Stream<Path> sources = Files.walk(Path.of("src/main/java/rigibo/backend"))) {
            sources.map(Path::toString)
                    .filter(name -> name.endsWith(".java"))
                    .forEach(command::add);
        }
        run("javac", command.toArray(String[]::new));
    }

    @Test
    void needsTheBaseOfJavaAlone() {
        String found =
                run("jdeps", "--module-path", "" + engine, "--list-deps", "-m", "rigibo.backend");
        assertThat(found.lines().map(String::strip)).containsExactly("java.base");
    }

    @Test
    void compilesTheExampleOnTheClassPath() {
        run("javac", "-d", "" + compiled, "-cp", "" + engine, "" + EXAMPLE);
        assertThat(compiled.resolve("rigibo/examples/FallingCrate.class")).exists();
    }

    @Test
    void compilesTheExampleAgainstWhatTheModuleExports() {
        JdkTool.Said said = compiledAgainstTheModule(EXAMPLE);
        assertThat(said.status()).as("%s", said.words()).isZero();
    }

    @Test
    void compilesTheTutorialAgainstWhatTheModuleExports() throws IOException {
        try (Stream<Path> programs = Files.list(TUTORIAL)) {
            for (Path program : programs.toList()) {
                JdkTool.Said said = compiledAgainstTheModule(program);
                assertThat(said.status()).as("%s", said.words()).isZero();
            }
        }
    }

    @Test
    void keepsItsRoomsToItself() throws IOException {
        Path curious = compiled.resolve("Curious.java");
        Files.writeString(curious, "class Curious { rigibo.backend.storage.Bodies bodies; }");
        JdkTool.Said said = compiledAgainstTheModule(curious);
        assertThat(said.status()).isNotZero();
        assertThat(said.words()).contains("package rigibo.backend.storage is not visible");
    }

    /** With an empty class path, for the compiler would otherwise take that of this test. */
    private JdkTool.Said compiledAgainstTheModule(Path source) {
        String to = "" + compiled;
        String module = "rigibo.backend";
        String path = "" + engine;
        return JdkTool.call(
                "javac", "-d", to, "-cp", "", "-p", path, "--add-modules", module, "" + source);
    }

    /** The output of a tool of the JDK when all is well. */
    private static String run(String tool, String... words) {
        JdkTool.Said said = JdkTool.call(tool, words);
        assertThat(said.status()).as("%s: %s", tool, said.words()).isZero();
        return said.words();
    }
}
