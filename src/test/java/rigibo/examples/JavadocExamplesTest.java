package rigibo.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Every public type that the engine's module exports shows in its Javadoc how it is used. */
class JavadocExamplesTest {

    private static final Path ENGINE =
            Path.of(System.getProperty("rigibo.home", ""), "src/main/java/rigibo/backend");

    private static final Pattern EXAMPLE =
            Pattern.compile("<pre>\\{@code\\R(.*?)\\R\\s*\\* \\}</pre>", Pattern.DOTALL);

    @TempDir private Path folder;

    private static List<Path> exported() throws IOException {
        Stream.Builder<Path> files = Stream.builder();
        for (String room : List.of("", "geometry", "setup", "effect")) {
            try (Stream<Path> inside = Files.list(ENGINE.resolve(room))) {
                inside.filter(file -> file.toString().endsWith(".java"))
                        .filter(file -> !file.endsWith("package-info.java"))
                        .sorted()
                        .forEach(files);
            }
        }
        return files.build().toList();
    }

    /** The Javadoc of the public type of a file; nothing where it has none. */
    private static Optional<String> words(String source) {
        Matcher type =
                Pattern.compile(
                                "^/\\*\\*.*?\\*/\\R(@\\w+\\R)*public"
                                        + " .*?(class|record|interface|enum) ",
                                Pattern.MULTILINE | Pattern.DOTALL)
                        .matcher(source);
        return type.find() ? Optional.of(type.group()) : Optional.empty();
    }

    @Test
    void everyTypeHasAnExampleBeforeItsMembers() throws IOException {
        for (Path file : exported()) {
            words(Files.readString(file))
                    .ifPresent(
                            words ->
                                    assertThat(EXAMPLE.matcher(words).find())
                                            .as("%s has an example", file.getFileName())
                                            .isTrue());
        }
    }

    @Test
    void everyExampleCompiles() throws IOException {
        assumeTrue(JdkTool.isThere("javac"), "this Java has no compiler");
        List<String> pieces = new ArrayList<>();
        for (Path file : exported()) {
            Matcher example = EXAMPLE.matcher(Files.readString(file));
            while (example.find()) {
                pieces.add(example.group(1).replaceAll("(?m)^\\s*\\* ?", ""));
            }
        }
        assertThat(pieces).hasSizeGreaterThan(50);
        JdkTool.Said said = Snippets.compile(folder, pieces);
        assertThat(said.status()).as("%s", said.words()).isZero();
    }
}
