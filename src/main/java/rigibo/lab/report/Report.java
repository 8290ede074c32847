package rigibo.lab.report;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The report of a measurement, for a terminal and for a page.
 *
 * @param method how it was measured; may be empty
 * @param passages tables, each with sentences about it
 */
public record Report(String method, List<Passage> passages) {

    /**
     * A table with a description before it and sentences after it.
     *
     * @param name heading at a terminal
     * @param title heading on a page; empty if the report is this table alone
     * @param what the description; may be empty
     */
    public record Passage(
            String name, String title, String what, Table table, List<String> sentences) {

        private Stream<String> text() {
            Stream<String> told = Stream.concat(table.text().stream(), sentences.stream());
            if (title.isEmpty()) {
                return told;
            }
            Stream<String> head = Stream.of(what.isEmpty() ? name : name + ": " + what);
            return Stream.of(head, told.map(line -> "  " + line), Stream.of(""))
                    .flatMap(lines -> lines);
        }

        private String markdown() {
            List<String> parts = new ArrayList<>();
            if (!title.isEmpty()) {
                parts.add("### " + title);
            }
            if (!what.isEmpty()) {
                parts.add(Character.toUpperCase(what.charAt(0)) + what.substring(1) + ".");
            }
            parts.add(table.markdown().stripTrailing());
            parts.addAll(sentences);
            return String.join("\n\n", parts);
        }
    }

    /** A report of one table and sentences after it. */
    public static Report of(Table table, List<String> sentences) {
        return new Report("", List.of(new Passage("", "", "", table, sentences)));
    }

    /** The lines for a terminal. */
    public List<String> text() {
        return passages.stream().flatMap(Passage::text).toList();
    }

    /** The measured part of a page of Markdown. */
    public String markdown(String provenance) {
        return Stream.concat(
                                Stream.of(provenance, method).filter(words -> !words.isEmpty()),
                                passages.stream().map(Passage::markdown))
                        .collect(Collectors.joining("\n\n"))
                + "\n";
    }
}
