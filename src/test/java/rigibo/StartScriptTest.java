package rigibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The script {@code rigibo} in a small checkout, with a Gradle of the test's own that counts how
 * often it is asked, and a program that tells where its class came from and what it was given.
 */
class StartScriptTest {

    /** Builds as soon as it may: until then whoever starts it waits. */
    private static final String GRADLE =
            """
            #!/bin/sh
            while [ "$1" != -p ]; do shift; done
            echo build >>"$HOME/builds"
            until [ -e "$HOME/go" ]; do sleep 0.02; done
            mkdir -p "$2/build/start" "$2/build/classes/rigibo"
            cp "$HOME/Echo.class" "$2/build/classes/rigibo/StartScriptTest\\$Echo.class"
            for program in play test lab jmh format; do
                echo '@checkout@/build/classes' >"$2/build/start/$program.classpath"
                printf '%s\\n' -cp @class-path@ 'rigibo.StartScriptTest$Echo' >"$2/build/start/$program.args"
            done
            """;

    @TempDir Path folder;
    private Path checkout;

    /** Tells where its class lies and its arguments, a line each. */
    static final class Echo {
        public static void main(String[] arguments) throws URISyntaxException {
            System.out.println(
                    Path.of(
                            Echo.class
                                    .getProtectionDomain()
                                    .getCodeSource()
                                    .getLocation()
                                    .toURI()));
            for (String argument : arguments) {
                System.out.println(argument);
            }
        }
    }

    @BeforeEach
    void makeCheckout() throws IOException {
        assumeThat(Path.of("/bin/sh")).exists();
        checkout = folder.resolve("checkout");
        for (String file : List.of("src/A.java", "levels/1.json", "gradle/x.gradle")) {
            write(checkout.resolve(file), file);
        }
        write(checkout.resolve("build.gradle"), "");
        write(checkout.resolve("settings.gradle"), "");
        Path script = Path.of(System.getProperty("rigibo.home", ""), "rigibo");
        Files.copy(script, checkout.resolve("rigibo"));
        Path echo = folder.resolve("Echo.class");
        try (var bytes = getClass().getResourceAsStream("StartScriptTest$Echo.class")) {
            Files.copy(bytes, echo);
        }
        Path gradle = folder.resolve("bin/gradle");
        write(gradle, GRADLE);
        assertThat(gradle.toFile().setExecutable(true)).isTrue();
        mayBuild();
    }

    private static void write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private void mayBuild() throws IOException {
        Files.writeString(folder.resolve("go"), "");
    }

    private int builds() throws IOException {
        Path builds = folder.resolve("builds");
        return Files.exists(builds) ? Files.readAllLines(builds).size() : 0;
    }

    private Process start(Path top, String... words) throws IOException {
        List<String> command =
                new ArrayList<>(List.of("/bin/sh", top.resolve("rigibo").toString()));
        command.addAll(List.of(words));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        Map<String, String> environment = builder.environment();
        environment.put("HOME", folder.toString());
        // The plainest there is, as in a job of cron's.
        environment.put("LC_ALL", "C");
        environment.put("JAVA_HOME", System.getProperty("java.home"));
        environment.keySet().removeAll(List.of("DISPLAY", "WAYLAND_DISPLAY"));
        environment.merge("PATH", folder.resolve("bin").toString(), (old, own) -> own + ":" + old);
        return builder.start();
    }

    private static List<String> ended(Process process) throws IOException {
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.onExit().join();
        return said.lines().collect(Collectors.toList());
    }

    private List<String> run(Path top, String... words) throws IOException {
        return ended(start(top, words));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"with space", "quo\"te", "dol$HOME", "back\\slash", "it's", "st*r", "-p"})
    void aCopiedCheckoutStartsItsOwnClassesWhateverItsPath(String name) throws Exception {
        run(checkout, "build");
        Path copy = folder.resolve(name);
        assertThat(
                        new ProcessBuilder("cp", "-r", checkout.toString(), copy.toString())
                                .start()
                                .waitFor())
                .isZero();
        List<String> said = run(copy, "levels", "a b", "", "\"c\"");
        assertThat(said)
                .endsWith(copy.resolve("build/classes").toString(), "levels", "a b", "", "\"c\"");
    }

    @Test
    void lettersBeyondAsciiInThePathNeedNoLocale() throws IOException {
        assumeThat(System.getProperty("sun.jnu.encoding")).isEqualTo("UTF-8");
        run(checkout, "build");
        Path moved = Files.move(checkout, folder.resolve("für Ōe"));
        assertThat(run(moved, "levels"))
                .containsExactly(moved.resolve("build/classes").toString(), "levels");
    }

    @Test
    void helpNeedsNoDisplay() throws IOException {
        assumeThat(System.getProperty("os.name")).isEqualTo("Linux");
        assertThat(run(checkout, "play", "--scene", "x", "--help")).endsWith("play", "--help");
    }

    @Test
    void aMovedCheckoutStartsItsOwnClassesWithoutABuild() throws IOException {
        run(checkout, "build");
        Path moved = Files.move(checkout, folder.resolve("moved"));
        assertThat(run(moved, "levels"))
                .containsExactly(moved.resolve("build/classes").toString(), "levels");
        assertThat(builds()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"co:lon", "new\nline"})
    void aPathThatNoClassPathCanNameIsRefused(String name) throws IOException {
        Path moved = Files.move(checkout, folder.resolve(name));
        assertThat(String.join(" ", run(moved, "levels"))).contains("without colons");
        assertThat(builds()).isZero();
    }

    @Test
    void whatDidNotChangeIsNotBuiltAgain() throws IOException {
        run(checkout, "build");
        assertThat(run(checkout, "build")).isEmpty();
        assertThat(builds()).isEqualTo(1);
    }

    /** As {@code cp -p}, {@code tar} and {@code mv} bring it. */
    @Test
    void aFileWithAnOldTimeIsBuilt() throws IOException {
        run(checkout, "build");
        Path other = folder.resolve("B.java");
        write(other, "src/B.java");
        Files.setLastModifiedTime(other, FileTime.fromMillis(0));
        Files.move(other, checkout.resolve("src/B.java"));
        run(checkout, "build");
        assertThat(builds()).isEqualTo(2);
    }

    @Test
    void aFileReplacedByOneOfItsSizeAndTimeIsBuilt() throws IOException {
        Path file = checkout.resolve("src/A.java");
        run(checkout, "build");
        FileTime time = Files.getLastModifiedTime(file);
        Files.writeString(file, "src/B.java");
        Files.setLastModifiedTime(file, time);
        run(checkout, "build");
        assertThat(builds()).isEqualTo(2);
    }

    @Test
    void aDeletedFileIsNoticed() throws IOException {
        run(checkout, "build");
        Files.delete(checkout.resolve("levels/1.json"));
        run(checkout, "build");
        assertThat(builds()).isEqualTo(2);
    }

    @Test
    void aSecondStartWaitsForTheFirstOnesBuildAndSaysSo() throws IOException {
        Files.delete(folder.resolve("go"));
        Process first = start(checkout, "levels");
        while (builds() == 0) {
            Thread.onSpinWait();
        }
        Process second = start(checkout, "levels");
        assertThat(second.inputReader().readLine()).contains("waiting");
        mayBuild();
        String classes = checkout.resolve("build/classes").toString();
        assertThat(ended(first)).contains(classes);
        assertThat(second.inputReader().lines()).containsExactly(classes, "levels");
        assertThat(builds()).isEqualTo(1);
        assertThat(checkout.resolve("build/start/lock")).doesNotExist();
    }

    @Test
    void aBuildThatWasKilledHoldsUpNobody() throws IOException {
        Files.delete(folder.resolve("go"));
        Process killed = start(checkout, "levels");
        while (builds() == 0) {
            Thread.onSpinWait();
        }
        killed.destroyForcibly().onExit().join();
        mayBuild();
        assertThat(run(checkout, "levels")).contains("levels");
        assertThat(builds()).isEqualTo(2);
    }
}
