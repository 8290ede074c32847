package rigibo.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/** A page in Markdown. */
public record Page(String text) {

    private static final Pattern BLOCK =
            Pattern.compile("^```(\\w*)\\n(.*?)^```$", Pattern.MULTILINE | Pattern.DOTALL);

    /** Reads a page. */
    public static Page read(Path file) throws IOException {
        return new Page(Files.readString(file).replace("\r\n", "\n"));
    }

    /** Its blocks of code in a language; in none where the language is empty. */
    public List<String> blocks(String language) {
        return BLOCK.matcher(text)
                .results()
                .filter(block -> block.group(1).equals(language))
                .map(block -> block.group(2))
                .toList();
    }

    /** The sentences outside of code, each cell of a table and each item of a list by itself. */
    public List<String> sentences() {
        return BLOCK.matcher(text)
                .replaceAll("")
                .lines()
                .flatMap(line -> Arrays.stream(line.split("(?<=[.!?:;])\\s+|\\|")))
                .map(String::strip)
                .filter(sentence -> !sentence.isEmpty())
                .toList();
    }

    /** The cells of the first row of a table that begins with a word, without that word. */
    List<String> row(String first) {
        String row =
                text.lines()
                        .filter(line -> line.startsWith("| " + first + " |"))
                        .findFirst()
                        .orElseThrow();
        return Arrays.stream(row.split("\\|")).skip(2).map(String::strip).toList();
    }
}
