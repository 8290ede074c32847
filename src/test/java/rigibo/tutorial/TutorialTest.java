package rigibo.tutorial;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.docs.Page;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;

/** Every chapter shows the program that runs here, and what it prints. */
@Isolated // The programs print, and the language of their numbers is the whole process's.
class TutorialTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));
    private static final Path CHAPTERS = HOME.resolve("docs/tutorial");
    private static final Path PROGRAMS = HOME.resolve("src/examples/java/rigibo/tutorial");

    private enum Chapter {
        FALLING_BOX("1-falling-box", "FallingBox", FallingBox::main),
        SLIDE_AND_BOUNCE("2-slide-and-bounce", "SlideAndBounce", SlideAndBounce::main),
        PENDULUM("3-pendulum", "Pendulum", Pendulum::main),
        TRAP_DOOR("4-trap-door", "TrapDoor", TrapDoor::main),
        LOOK_AHEAD("5-look-ahead", "LookAhead", LookAhead::main),
        TOWERS("6-towers", "Towers", Towers::main),
        CUT_THE_ROPE("7-cut-the-rope", "CutTheRope", CutTheRope::main);

        private final String file;
        private final String program;
        private final Consumer<String[]> main;

        Chapter(String file, String program, Consumer<String[]> main) {
            this.file = file;
            this.program = program;
            this.main = main;
        }

        Page page() throws IOException {
            return Page.read(CHAPTERS.resolve(file + ".md"));
        }
    }

    @ParameterizedTest
    @EnumSource
    void theProgramPrintsWhatTheChapterSays(Chapter chapter) throws IOException {
        assertThat(chapter.page().blocks("")).containsExactly(printed(chapter.main));
    }

    private static String printed(Consumer<String[]> main) {
        PrintStream before = System.out;
        Locale locale = Locale.getDefault();
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        Locale.setDefault(Locale.ROOT);
        try {
            main.accept(new String[0]);
        } finally {
            System.setOut(before);
            Locale.setDefault(locale);
        }
        return printed.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n");
    }

    @ParameterizedTest
    @EnumSource
    void theCodeShownIsTheProgramS(Chapter chapter) throws IOException {
        String program = Files.readString(PROGRAMS.resolve(chapter.program + ".java"));
        assertThat(chapter.page().blocks("java"))
                .isNotEmpty()
                .allSatisfy(block -> assertThat(flush(program)).contains(flush(block)));
    }

    /** The lines of a text, whatever their indentation. */
    private static String flush(String text) {
        return text.replaceAll("(?m)^ +", "").strip();
    }

    @Test
    void everyChapterHasItsPicture() throws IOException {
        Map<String, String> drawn = TutorialPictures.all();
        for (Chapter chapter : Chapter.values()) {
            String picture = chapter.file + ".svg";
            assertThat(chapter.page().text()).contains("](pictures/" + picture + ")");
            assertThat(drawn.get(picture)).contains("<polygon");
            assertThat(CHAPTERS.resolve("pictures").resolve(picture)).exists();
        }
    }
}
