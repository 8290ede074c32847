package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Effect;
import rigibo.backend.geometry.ShapeKind;
import rigibo.backend.setup.JointKind;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Every switch over the kinds of effects, shapes or joints names all of them. The compiler finds a
 * missing kind only in switches that are expressions; a statement would ignore it.
 */
class SwitchesOverKindsTest {

    private static final Path SOURCES =
            Path.of(System.getProperty("rigibo.home", "")).resolve("src/main/java");

    private static final List<Class<? extends Enum<?>>> KINDS =
            List.of(Effect.Kind.class, ShapeKind.class, JointKind.class);

    private static final Pattern SWITCH = Pattern.compile("\\bswitch \\(");
    private static final Pattern CASE = Pattern.compile("\\bcase ([A-Z_]+(?:,\\s*[A-Z_]+)*) ->");

    static List<Path> files() throws IOException {
        try (Stream<Path> files = Files.walk(SOURCES)) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .filter(SwitchesOverKindsTest::hasSwitch)
                    .toList();
        }
    }

    private static boolean hasSwitch(Path file) {
        return SWITCH.matcher(text(file)).find();
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException cause) {
            throw new IllegalStateException(cause);
        }
    }

    @ParameterizedTest
    @MethodSource("files")
    void namesAllKinds(Path file) {
        String text = text(file);
        Matcher found = SWITCH.matcher(text);
        while (found.find()) {
            String block = block(text, text.indexOf('{', found.end()));
            Set<String> named = named(block);
            for (Class<? extends Enum<?>> kind : KINDS) {
                Set<String> all = names(kind);
                // Fewer names may be of an enum that shares some, such as a case's own kinds.
                if (2 * named.size() > all.size() && all.containsAll(named)) {
                    boolean hasDefault = block.contains("default ->");
                    assertThat(hasDefault ? all : named)
                            .as("%s in %s", kind.getSimpleName(), SOURCES.relativize(file))
                            .isEqualTo(all);
                }
            }
        }
    }

    private static String block(String text, int open) {
        int depth = 0;
        for (int at = open; at < text.length(); at++) {
            depth += text.charAt(at) == '{' ? 1 : text.charAt(at) == '}' ? -1 : 0;
            if (depth == 0) {
                return text.substring(open, at);
            }
        }
        throw new IllegalStateException("no end of a block");
    }

    private static Set<String> named(String block) {
        Set<String> names = new TreeSet<>();
        Matcher label = CASE.matcher(block);
        while (label.find()) {
            names.addAll(Arrays.asList(label.group(1).split(",\\s*")));
        }
        return names;
    }

    private static Set<String> names(Class<? extends Enum<?>> kind) {
        return Arrays.stream(kind.getEnumConstants())
                .map(Enum::name)
                .collect(Collectors.toCollection(TreeSet::new));
    }
}
